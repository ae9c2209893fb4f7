// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "mesh/structure/TriangleSoup.h"
#include "volume/SparseVolume.h"
#include "volume/repair/BoundaryCaps.h"

#include <optional>
#include <vector>

namespace handwheel {

// A surface prepared for voxelisation: welded, closed by cones, and in voxels of its grid.
struct ClosedSurfaceInVoxels {
  TriangleSoup closed;  // in voxels
  BoundaryCaps caps;
  SparseVolume grid;  // an empty volume with a margin around the surface
  Box bounds;         // mm

  // Returns the number of blocks that the grid needs along each axis, counted from its origin.
  VoxelIndex blocks() const;
  // Returns the signed volume inside, mm³. Overlaps count several times.
  double enclosed() const;
  // Returns the fraction of the area of some triangles that is near the volume's surface, measured at points all over
  // these triangles. isUsed: true for each triangle of `closed` to measure. Returns 0 if cancelled.
  double nearShare(const SparseVolume& volume, const std::vector<bool>& isUsed, const Progress& progress) const;
  // Returns the error for a volume without material: VolumeErrors::NoVoxelInside or NothingInside.
  Error nothingInside() const;
};

// Returns the fraction of points, in voxels of the volume's grid, that have inside and outside samples among the 4³
// samples around them. All other points are farther than a voxel from the surface. Returns 1 for no points, and 0 if
// cancelled.
double nearShare(const SparseVolume& volume, const std::vector<Vec3>& points, const Progress& progress);

// Returns an error if a volume does not represent its surface: it kept less than kLeastKept of the surface's area, or
// of the enclosed volume. The material is measured by the number of samples inside, and, if that is too little, also up
// to the surface between the samples; the larger result counts. nearShare: the fraction of the surface that was kept;
// expected: the volume of the solid, mm³. Errors: VolumeErrors::SurfaceIsLost, MaterialIsLost.
std::optional<Error> lossRefusal(const SparseVolume& volume, double nearShare, double expected);

// Prepares a surface for voxelisation. wideFrom: see closeBoundaries(). alignedTo: see volumeOfSurface(). O(n log n).
// Errors: MeshError::NoTriangles, NumberNotFinite, ValueOutOfRange (for the voxel), VolumeErrors::TooFine, TooLarge
// (for the volume, its triangles and the cones); Cancelled.
Result<ClosedSurfaceInVoxels> closedInVoxels(const TriangleSoup& soup, double voxel, double wideFrom,
                                             const std::optional<Vec3>& alignedTo, Progress progress);
// Prepares a surface whose voxels are not all made at once. Returns the errors of closedInVoxels() except TooLarge.
Result<ClosedSurfaceInVoxels> closedInGrid(const TriangleSoup& soup, double voxel, double wideFrom,
                                           const std::optional<Vec3>& alignedTo, Progress progress);

}  // namespace handwheel
