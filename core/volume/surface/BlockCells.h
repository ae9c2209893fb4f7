// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"
#include "volume/surface/MarchingCubesTable.h"

#include <array>
#include <cstdint>

namespace handwheel {

// The 8³ cells of a block, which are cubes between samples. Cells at the upper sides extend to the first samples of the
// next blocks. A block owns the edges that begin at its samples.
class BlockCells {
 public:
  static constexpr std::size_t kEdges = 3 * VolumeBlock::kCount;  // index of an edge: 3 · sample + axis

  // An edge of the block, or of a neighbouring block that follows it along some axes.
  struct Edge {
    VoxelIndex block;  // offset of the block that owns the edge, 0 or 1 along each axis
    std::size_t edge;
  };

  BlockCells(const SparseVolume& volume, const VoxelIndex& block);

  // Calls visit(edge, position of the surface on the edge, from 0 to 1) for each edge that the surface crosses, in
  // ascending order of the edges.
  template <class Visit>
  void forEachCrossedEdge(Visit visit) const {
    constexpr std::array<std::size_t, 3> kSteps{1, kSide, kSide * kSide};
    for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
      const std::size_t at = sampleIndex(i & 7, i >> 3 & 7, i >> 6);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const int from = m_samples[at], to = m_samples[at + kSteps[axis]];
        if ((from > 0) != (to > 0)) visit(3 * static_cast<std::size_t>(i) + axis, shareToSurface(from, to));
      }
    }
  }

  // Calls visit(the three edges of the corners) for each triangle of the surface in the cells of the block.
  template <class Visit>
  void forEachTriangle(Visit visit) const {
    const MarchingCubesTable& table = MarchingCubesTable::table();
    for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
      const VoxelIndex cell(i & 7, i >> 3 & 7, i >> 6);
      unsigned inside = 0;
      for (int c = 0; c < 8; ++c)
        if (m_samples[sampleIndex(cell.x() + (c & 1), cell.y() + (c >> 1 & 1), cell.z() + (c >> 2))] > 0)
          inside |= 1u << c;
      for (const MarchingCubesTable::EdgeTriangle& t : table.triangles[inside])
        visit(std::array<Edge, 3>{edgeOf(cell, t[0]), edgeOf(cell, t[1]), edgeOf(cell, t[2])});
    }
  }

  // Returns the point at a fraction of an edge, mm.
  Vec3 pointOn(std::size_t edge, double share) const {
    const auto i = static_cast<int>(edge / 3);
    Vec3 at = (m_first + VoxelIndex(i & 7, i >> 3 & 7, i >> 6)).cast<double>();
    at[static_cast<Eigen::Index>(edge % 3)] += share;
    return m_origin + m_voxel * at;
  }

 private:
  static constexpr std::size_t kSide = VolumeBlock::kSize + 1;

  static std::size_t sampleIndex(int x, int y, int z) {
    return (static_cast<std::size_t>(z) * kSide + static_cast<std::size_t>(y)) * kSide + static_cast<std::size_t>(x);
  }
  static Edge edgeOf(const VoxelIndex& cell, int edge);

  VoxelIndex m_first;  // first voxel of the block
  Vec3 m_origin;
  double m_voxel;
  std::array<std::int16_t, kSide * kSide * kSide> m_samples;
};

}  // namespace handwheel
