// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "volume/SparseVolume.h"
#include "volume/repair/SolidAngleTree.h"
#include "volume/surface/ScanlineCrossings.h"

#include <array>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace handwheel {

// Membranes that close wide curved holes, by the generalised winding number. A membrane is the surface where the
// winding number, the sum of the solid angles of the surface, is one half. It is smooth over a hole, meets the surface
// at the edge of the hole, and is planar if that edge is planar. Its shape depends on the whole surface, not only on
// the centre of the hole.
//
// The winding number is the integer winding number of the surface closed by cones (ScanlineCrossings), minus the solid
// angle of the cones. So the two numbers differ noticeably only in the blocks around the cones, and the generalised one
// is evaluated only in these blocks.
class WindingNumberFill {
 public:
  // closed: closed surface in voxels. cones: the triangles of `closed` that are over wide holes. The object is empty if
  // cancelled.
  WindingNumberFill(const TriangleSoup& closed, std::span<const std::uint32_t> cones, const Progress& progress);

  // Predicts the number of blocks. The holes are treated separately; the result is right to a factor of two unless they
  // influence each other. O(n).
  static double predictedBlocks(const TriangleSoup& closed, std::span<const std::uint32_t> cones);
  static constexpr double kWide = 4.0;     // voxels; narrower holes are closed by cones instead of membranes
  static constexpr double kBytes = 160.0;  // bytes of memory per block while the volume is made

  bool isEmpty() const { return m_blocks.empty(); }
  // Returns the blocks that membranes may pass. In other blocks, the integer winding number decides.
  const std::vector<VoxelIndex>& blocks() const { return m_blocks; }
  bool contains(const VoxelIndex& block) const { return m_near.contains(keyOf(block)); }
  // Returns true for a block that neither a membrane nor a cone comes near, so that its voxels are on the same side
  // unless other triangles pass through it.
  bool isFarFromMembranes(const VoxelIndex& block) const {
    return !isNear(block) && !m_coneBlocks.contains(keyOf(block));
  }
  bool isInside(const VoxelIndex& voxel, const ScanlineCrossings& rows) const {
    return winding(voxel.cast<double>(), rows.winding(voxel)) > 0.5;
  }
  // Returns the winding number at a point. closed: the winding number of the closed surface at the point.
  double winding(const Vec3& p, int closed) const { return closed - m_cones.turns(p); }

  struct Samples {
    std::array<bool, VolumeBlock::kCount> isInside;
    std::array<float, VolumeBlock::kCount>
        distance;  // voxels, distance from a membrane, of first order; kNone: far from all membranes
  };
  static constexpr float kNone = 1e9F;
  // Returns the samples of one of the blocks.
  Samples samples(const VoxelIndex& block, const ScanlineCrossings& rows) const;

 private:
  static std::uint64_t keyOf(const VoxelIndex& block);
  bool isNear(const VoxelIndex& block) const;

  SolidAngleTree m_cones;
  std::vector<VoxelIndex> m_blocks;
  std::unordered_set<std::uint64_t> m_coneBlocks;  // blocks that a cone may pass through
  std::unordered_map<std::uint64_t, bool>
      m_near;  // for each block: true if a membrane may pass through it or beside it
};

}  // namespace handwheel
