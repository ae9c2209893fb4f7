// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <cstdint>
#include <vector>

namespace handwheel {

// Triangles for a graphics card.
struct VolumeTriangles {
  std::vector<float> points;          // x, y and z of each point, mm, relative to a nearby origin
  std::vector<float> normals;         // unit vectors, outwards
  std::vector<std::int32_t> corners;  // three per triangle

  std::size_t count() const { return corners.size() / 3; }
  // Appends a range of the points and corners of other triangles, which must have the same origin. The corners
  // of the range must refer to points of the range, by their indices in `other`.
  void append(const VolumeTriangles& other, std::size_t firstPoint, std::size_t pointCount, std::size_t firstCorner,
              std::size_t cornerCount);
};

// Returns the surface in the cells of one block, by marching cubes. The vertices have the positions of surfaceOf(), and
// are not shared with other blocks. Normals are gradients of the depths, so that neighbouring blocks are shaded alike.
// origin: the origin of the points, mm.
VolumeTriangles blockTriangles(const SparseVolume& volume, const VoxelIndex& block, const Vec3& origin);

// Returns the coarse surface in a cube of `cells`³ cells that begins at a voxel. Only every `stride`-th sample is used.
VolumeTriangles coarseTriangles(const SparseVolume& volume, const VoxelIndex& first, int cells, int stride,
                                const Vec3& origin);

}  // namespace handwheel
