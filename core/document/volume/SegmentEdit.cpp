// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/SegmentEdit.h"

#include "document/volume/VolumeDocument.h"

#include <utility>

namespace handwheel {

void SegmentEdit::exchange(Document& document) {
  auto& volume = static_cast<VolumeDocument&>(document);
  std::swap(volume.m_segment, m_segment);
  volume.wasChanged();
}

}  // namespace handwheel
