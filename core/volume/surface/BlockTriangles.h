// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <cstdint>
#include <vector>

namespace handwheel {

// Triangles for a graphics card.
struct VolumeTriangles {
  std::vector<float> points;          // x y z …, mm from an origin near them
  std::vector<float> normals;         // unit vectors, outwards
  std::vector<std::int32_t> corners;  // three per triangle

  std::size_t count() const { return corners.size() / 3; }
  // Appends a range of points and corners of others with the same origin. The corners count from firstPoint.
  void append(const VolumeTriangles& other, std::size_t firstPoint, std::size_t pointCount, std::size_t firstCorner,
              std::size_t cornerCount);
};

// Returns the surface in the cells of one block, by marching cubes, with vertices of its own at the positions of
// surfaceOf(). Normals are gradients of the depths, so that neighbouring blocks are shaded alike. origin: mm.
VolumeTriangles blockTriangles(const SparseVolume& volume, const VoxelIndex& block, const Vec3& origin);

// Returns the surface of every `stride`-th sample in a cube of `cells`³ such cells, beginning at a voxel.
VolumeTriangles coarseTriangles(const SparseVolume& volume, const VoxelIndex& first, int cells, int stride,
                                const Vec3& origin);

}  // namespace handwheel
