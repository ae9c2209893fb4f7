// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"
#include "volume/SparseVolume.h"
#include "volume/surface/ScanlineCrossings.h"

#include <vector>

namespace handwheel {

// Computes distances of a cube of voxels from triangles, and makes signed blocks of them. All lengths are in voxels. A
// block depends only on the triangles near it, so that tiles that are made separately fit together.
class SurfaceTile {
 public:
  static constexpr int kSide = 32;                            // voxels along an edge of a tile
  static constexpr int kBlocks = kSide / VolumeBlock::kSize;  // blocks along an edge of a tile
  static constexpr int kAllBlocks = kBlocks * kBlocks * kBlocks;
  static constexpr double kBand = 3.0;  // distances are exact up to this distance from the surface
  static constexpr float kFar = static_cast<float>(kBand * kBand);

  struct Corners {
    Vec3 a, b, c;
    Vec3 normal;  // unit vector; zero for a triangle without area

    Corners(const Vec3& first, const Vec3& second, const Vec3& third);
    Corners(const TriangleSoup& soup, const Triangle& t)
        : Corners(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]) {}
    Vec3 low() const { return a.cwiseMin(b).cwiseMin(c); }
    Vec3 high() const { return a.cwiseMax(b).cwiseMax(c); }
  };

  // first: the voxel of the tile with the lowest indices.
  explicit SurfaceTile(const VoxelIndex& first);

  // Adds a triangle. For results that are identical to the last bit, the calls must always be made in the same order.
  void add(const Corners& t);

  // Returns the squared distance of a voxel from the triangles, at most kFar. inTile: the index of the voxel relative
  // to the first.
  float squared(const VoxelIndex& inTile) const { return m_squared[index(inTile.x(), inTile.y(), inTile.z())]; }
  // Returns the signed block that begins at this voxel, or null if no voxel of the block is within the band. inTile:
  // the index of the voxel relative to the first. rows: the crossings of all triangles.
  SparseVolume::Block signedBlock(const VoxelIndex& inTile, const ScanlineCrossings& rows) const;

  // Returns the index, relative to the first block, of the block with this number. Numbers are below kAllBlocks, x
  // fastest.
  static VoxelIndex blockAt(int number) {
    return {number % kBlocks, number / kBlocks % kBlocks, number / kBlocks / kBlocks};
  }

  // Returns the value of the sample for a squared distance from the surface.
  static std::int16_t sampleAt(float squared, bool isInside);

 private:
  static std::size_t index(int x, int y, int z) { return static_cast<std::size_t>((z * kSide + y) * kSide + x); }

  VoxelIndex m_first;
  std::vector<float> m_squared;
};

}  // namespace handwheel
