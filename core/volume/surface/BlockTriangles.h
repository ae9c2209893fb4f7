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
  std::vector<float> normals;         // of length 1, outwards
  std::vector<std::int32_t> corners;  // three to a triangle

  std::size_t count() const { return corners.size() / 3; }
  // Adds others from the same origin: the points from firstPoint on, and the corners, which count from there, from
  // firstCorner on.
  void append(const VolumeTriangles& other, std::size_t firstPoint, std::size_t pointCount, std::size_t firstCorner,
              std::size_t cornerCount);
};

// The surface in the cells of one block, by marching cubes, with vertices of its own; normals are those of the depths,
// so that neighbours are shaded alike. origin: mm. The same places as surfaceOf() gives.
VolumeTriangles blockTriangles(const SparseVolume& volume, const VoxelIndex& block, const Vec3& origin);

// The same of every `stride`-th sample, in (cells)³ of such cells from a voxel on.
VolumeTriangles coarseTriangles(const SparseVolume& volume, const VoxelIndex& first, int cells, int stride,
                                const Vec3& origin);

}  // namespace handwheel
