// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/VolumeEdit.h"

#include "document/volume/VolumeDocument.h"

namespace handwheel {

void VolumeEdit::exchange(Document& document) {
  auto& volume = static_cast<VolumeDocument&>(document);
  std::swap(volume.m_volume, m_volume);
  volume.wasChanged();
}

std::size_t VolumeEdit::bytes() const {
  // A block has some hundred triangles where the surface passes through it.
  constexpr std::size_t kSurface = 150 * (sizeof(Triangle) + sizeof(Vec3) / 2);
  return sizeof *this + m_changedBlocks * (sizeof(VolumeBlock) + kSurface);
}

}  // namespace handwheel
