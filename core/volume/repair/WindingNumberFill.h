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

// Surfaces that close wide curved holes, by the generalised winding number. They are where it, the sum of the solid
// angles of the surface, passes a half. Each is smooth over a hole, meets the surface at its edge, and is the plane of
// a hole with a flat edge; what is left of the surface shapes it, and not the middle of the hole alone.
//
// The winding number is the whole one of the surface that cones close (ScanlineCrossings), less the solid angle of the
// cones. So it differs from that, and is looked at, only in the blocks around the cones.
class WindingNumberFill {
 public:
  // closed: in voxels. cones: of its triangles, those over the wide holes. Nothing once cancelled.
  WindingNumberFill(const TriangleSoup& closed, std::span<const std::uint32_t> cones, const Progress& progress);

  // How many blocks there are going to be, within a factor of two, as far as one hole does not shadow another. O(n).
  static double predictedBlocks(const TriangleSoup& closed, std::span<const std::uint32_t> cones);
  static constexpr double kWide = 4.0;     // voxels, of a hole that a membrane closes, and no lid
  static constexpr double kBytes = 160.0;  // of a block, while the volume is made

  bool isEmpty() const { return m_blocks.empty(); }
  // The blocks where they can be; elsewhere the whole winding number tells what is inside.
  const std::vector<VoxelIndex>& blocks() const { return m_blocks; }
  bool contains(const VoxelIndex& block) const { return m_near.contains(keyOf(block)); }
  // The winding number at a place, given that of the closed surface.
  double winding(const Vec3& p, int closed) const { return closed - m_cones.turns(p); }

  struct Samples {
    std::array<bool, VolumeBlock::kCount> isInside;
    std::array<float, VolumeBlock::kCount> distance;  // voxels, from a membrane, first order; kNone: far
  };
  static constexpr float kNone = 1e9F;
  // Of one of the blocks.
  Samples samples(const VoxelIndex& block, const ScanlineCrossings& rows) const;

 private:
  static std::uint64_t keyOf(const VoxelIndex& block);
  bool isNear(const VoxelIndex& block) const;

  SolidAngleTree m_cones;
  std::vector<VoxelIndex> m_blocks;
  std::unordered_map<std::uint64_t, bool> m_near;  // of the blocks: whether a membrane can pass through or beside it
};

}  // namespace handwheel
