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
  TriangleSoup closed;  // voxels
  BoundaryCaps caps;
  SparseVolume grid;  // empty, with room around the surface
  Box bounds;         // mm

  // How many blocks the grid has to hold along each axis, from its origin on.
  VoxelIndex blocks() const;
  // Signed volume inside, in mm³; of overlaps each counts.
  double enclosed() const;
  // The share of the area of some triangles that is near the volume's surface, by places all over them. 0 if cancelled.
  double nearShare(const SparseVolume& volume, const std::vector<bool>& isUsed, const Progress& progress) const;
  // Why a volume without material is none. Errors: VolumeErrors::NoVoxelInside, NothingInside.
  Error nothingInside() const;
};

// The share of places, in voxels of the volume's grid, that have samples of both sides among the 4 x 4 x 4 around them.
// All others are farther than a voxel from its surface. 1 of no places; 0 if cancelled.
double nearShare(const SparseVolume& volume, const std::vector<Vec3>& places, const Progress& progress);

// The error where a volume is none of the surface that it was made of: it kept less than kLeastKept of what bounds it,
// or of what it encloses, by its samples and up to its surface. Errors: VolumeErrors::SurfaceIsLost, MaterialIsLost.
// expected: mm³, that it has to hold.
std::optional<Error> lossRefusal(const SparseVolume& volume, double nearShare, double expected);

// wideFrom: as of closeBoundaries(). alignedTo: as of volumeOfSurface(). O(n log n). Errors: MeshError::NoTriangles,
// NumberNotFinite, ValueOutOfRange (of the voxel), VolumeErrors::TooFine, TooLarge (what the volume and its triangles
// take, and such cones); Cancelled.
Result<ClosedSurfaceInVoxels> closedInVoxels(const TriangleSoup& soup, double voxel, double wideFrom,
                                             const std::optional<Vec3>& alignedTo, Progress progress);
// The same for voxels that are not all made at once: without TooLarge.
Result<ClosedSurfaceInVoxels> closedInGrid(const TriangleSoup& soup, double voxel, double wideFrom,
                                           const std::optional<Vec3>& alignedTo, Progress progress);

}  // namespace handwheel
