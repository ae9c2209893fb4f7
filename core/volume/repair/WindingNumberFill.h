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
#include <vector>

namespace handwheel {

// Membranes that close wide curved holes, by the generalised winding number. They are the level set of one half of the
// winding number, the sum of the solid angles of the surface. A membrane is smooth over a hole, meets the surface at
// its edge, and is planar for a hole with a planar edge; it is shaped by the whole surface, not only by the centre of
// the hole.
//
// The winding number is the integer one of the surface closed by cones (ScanlineCrossings), minus the solid angle of
// the cones. So it differs from that, and is evaluated, only in the blocks around the cones.
class WindingNumberFill {
 public:
  // closed: in voxels. cones: those of its triangles that are over the wide holes. Empty if cancelled.
  WindingNumberFill(const TriangleSoup& closed, std::span<const std::uint32_t> cones, const Progress& progress);

  // Predicts the number of blocks to a factor of two, unless one hole shadows another. O(n).
  static double predictedBlocks(const TriangleSoup& closed, std::span<const std::uint32_t> cones);
  static constexpr double kWide = 4.0;  // voxels, least width of a hole that is closed by a membrane and not by a lid
  static constexpr double kBytes = 160.0;  // memory per block while the volume is made

  bool isEmpty() const { return m_blocks.empty(); }
  // Blocks that membranes may pass; elsewhere the integer winding number decides.
  const std::vector<VoxelIndex>& blocks() const { return m_blocks; }
  bool contains(const VoxelIndex& block) const { return m_near.contains(keyOf(block)); }
  // Returns the winding number at a point, given that of the closed surface.
  double winding(const Vec3& p, int closed) const { return closed - m_cones.turns(p); }

  struct Samples {
    std::array<bool, VolumeBlock::kCount> isInside;
    std::array<float, VolumeBlock::kCount> distance;  // voxels, distance from a membrane, of first order; kNone: far
  };
  static constexpr float kNone = 1e9F;
  // Returns the samples of one of the blocks.
  Samples samples(const VoxelIndex& block, const ScanlineCrossings& rows) const;

 private:
  static std::uint64_t keyOf(const VoxelIndex& block);
  bool isNear(const VoxelIndex& block) const;

  SolidAngleTree m_cones;
  std::vector<VoxelIndex> m_blocks;
  std::unordered_map<std::uint64_t, bool>
      m_near;  // for each block: true if a membrane may pass through it or beside it
};

}  // namespace handwheel
