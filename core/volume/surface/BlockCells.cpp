// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/surface/BlockCells.h"

namespace handwheel {

BlockCells::BlockCells(const SparseVolume& volume, const VoxelIndex& block)
    : m_first(VolumeBlock::kSize * block), m_origin(volume.origin()), m_voxel(volume.voxel()) {
  constexpr int n = VolumeBlock::kSize;
  for (int k = 0; k < 8; ++k) {
    const VoxelIndex next(k & 1, k >> 1 & 1, k >> 2);
    const SparseVolume::View content = volume.view(block + next);
    const std::int16_t uniform = content.isFull ? VolumeBlock::kFull : VolumeBlock::kEmpty;
    const VoxelIndex size = (1 - next.array()) * (n - 1) + 1;
    for (int z = 0; z < size.z(); ++z)
      for (int y = 0; y < size.y(); ++y)
        for (int x = 0; x < size.x(); ++x)
          m_samples[sampleIndex(n * next.x() + x, n * next.y() + y, n * next.z() + z)] =
              content.block ? content.block->depths[VolumeBlock::at(x, y, z)] : uniform;
  }
}

BlockCells::Edge BlockCells::edgeOf(const VoxelIndex& cell, int edge) {
  const int low = cornersOfCellEdge(edge)[0];
  const VoxelIndex at = cell + VoxelIndex(low & 1, low >> 1 & 1, low >> 2);
  return {at.unaryExpr([](int i) { return i >> 3; }),
          3 * VolumeBlock::at(at.x() & 7, at.y() & 7, at.z() & 7) + static_cast<std::size_t>(edge / 4)};
}

}  // namespace handwheel
