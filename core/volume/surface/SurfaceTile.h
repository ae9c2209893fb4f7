// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"
#include "volume/SparseVolume.h"
#include "volume/surface/ScanlineCrossings.h"

#include <vector>

namespace handwheel {

// Distances of a cube of voxels from triangles, which become signed blocks. All in voxels. A block depends only on the
// triangles near it, so that tiles that are made separately fit together.
class SurfaceTile {
 public:
  static constexpr int kSide = 32;                            // voxels along an edge of a tile
  static constexpr int kBlocks = kSide / VolumeBlock::kSize;  // blocks along an edge
  static constexpr int kAllBlocks = kBlocks * kBlocks * kBlocks;
  static constexpr double kBand = 3.0;  // distance from the surface up to which distances are exact
  static constexpr float kFar = static_cast<float>(kBand * kBand);

  struct Corners {
    Vec3 a, b, c;
    Vec3 normal;  // unit; zero for a triangle without area

    Corners(const Vec3& first, const Vec3& second, const Vec3& third);
    Corners(const TriangleSoup& soup, const Triangle& t)
        : Corners(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]) {}
    Vec3 low() const { return a.cwiseMin(b).cwiseMin(c); }
    Vec3 high() const { return a.cwiseMax(b).cwiseMax(c); }
  };

  // first: the tile's voxel with the lowest indices.
  explicit SurfaceTile(const VoxelIndex& first);

  // Adds a triangle. The order of the calls must be fixed, for results that are identical to the last bit.
  void add(const Corners& t);

  // Returns the squared distance of a voxel, counted from the first, at most kFar.
  float squared(const VoxelIndex& inTile) const { return m_squared[index(inTile.x(), inTile.y(), inTile.z())]; }
  // Returns the signed block beginning at this voxel; null if the band does not reach it. rows: crossings of all
  // triangles.
  SparseVolume::Block signedBlock(const VoxelIndex& inTile, const ScanlineCrossings& rows) const;

  // Returns the index of a block, counted from the first, for its number below kAllBlocks, x fastest.
  static VoxelIndex blockAt(int number) {
    return {number % kBlocks, number / kBlocks % kBlocks, number / kBlocks / kBlocks};
  }

  // Returns the sample for a squared distance from the surface.
  static std::int16_t sampleAt(float squared, bool isInside);

 private:
  static std::size_t index(int x, int y, int z) { return static_cast<std::size_t>((z * kSide + y) * kSide + x); }

  VoxelIndex m_first;
  std::vector<float> m_squared;
};

}  // namespace handwheel
