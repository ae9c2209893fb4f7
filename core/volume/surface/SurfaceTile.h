// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"
#include "volume/SparseVolume.h"
#include "volume/surface/ScanlineCrossings.h"

#include <vector>

namespace handwheel {

// Distances of a cube of voxels from triangles, which become signed blocks. All in voxels. A block is the same whatever
// else is added that does not come near it, so that tiles that are made apart fit together.
class SurfaceTile {
 public:
  static constexpr int kSide = 32;                            // voxels along an edge of a tile
  static constexpr int kBlocks = kSide / VolumeBlock::kSize;  // along it
  static constexpr int kAllBlocks = kBlocks * kBlocks * kBlocks;
  static constexpr double kBand = 3.0;  // from the surface, in which distances are exact
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

  // first: the tile's voxel with the lowest numbers.
  explicit SurfaceTile(const VoxelIndex& first);

  // To be called for triangles in one order, so that results are the same to the last bit.
  void add(const Corners& t);

  // The squared distance of a voxel, counted from the first; kFar where it is that or more.
  float squared(const VoxelIndex& inTile) const { return m_squared[index(inTile.x(), inTile.y(), inTile.z())]; }
  // The block from this voxel on, signed; null where nothing of the band is in it. rows: of all triangles.
  SparseVolume::Block signedBlock(const VoxelIndex& inTile, const ScanlineCrossings& rows) const;

  // The place of a block by its number from 0 to kAllBlocks, x fastest; in blocks, counted from the first.
  static VoxelIndex blockAt(int number) {
    return {number % kBlocks, number / kBlocks % kBlocks, number / kBlocks / kBlocks};
  }

  // A sample so far from a surface, its square in voxels.
  static std::int16_t sampleAt(float squared, bool isInside);

 private:
  static std::size_t index(int x, int y, int z) { return static_cast<std::size_t>((z * kSide + y) * kSide + x); }

  VoxelIndex m_first;
  std::vector<float> m_squared;
};

}  // namespace handwheel
