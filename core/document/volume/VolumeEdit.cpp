// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/VolumeEdit.h"

#include "document/volume/VolumeDocument.h"

#include <algorithm>

namespace handwheel {

void VolumeEdit::exchange(Document& document) {
  auto& volume = static_cast<VolumeDocument&>(document);
  std::swap(volume.m_volume, m_volume);
  volume.wasChanged();
}

bool VolumeEdit::absorb(const Edit& later) {
  const auto* const next = dynamic_cast<const VolumeEdit*>(&later);
  if (!next || m_property.empty() || next->m_property != m_property) return false;
  m_changedBlocks = std::max(m_changedBlocks, next->m_changedBlocks);
  return true;
}

std::size_t VolumeEdit::bytes() const {
  // A block has some hundred triangles where the surface passes through it.
  constexpr std::size_t kSurface = 150 * (sizeof(Triangle) + sizeof(Vec3) / 2);
  return sizeof *this + m_changedBlocks * (sizeof(VolumeBlock) + kSurface);
}

}  // namespace handwheel
