// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "mesh/structure/TriangleSoup.h"
#include "volume/SparseVolume.h"
#include "volume/repair/ThinParts.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace handwheel {

// A volume made of a surface, with checks that it is the enclosed solid.
struct SurfaceVolume {
  SparseVolume volume;
  std::size_t closedBoundaries = 0;  // number of closed holes, gaps and flipped faces
  // Volume inside the surface closed by cones, mm³. It is computed from triangles; overlaps count several times.
  double expected = 0.0;
  // Approximate fraction of the material-bounding area of the surface that is within a voxel of the volume's surface.
  double nearShare = 0.0;
  std::vector<Vec3> kept;         // mm, points all over the surface that certainly bound material
  std::size_t removedCrumbs = 0;  // parts left at ragged rims, which were removed (CrumbRemoval.h)
  ThinParts thin;                 // walls and gaps that are thinner than two voxels
};

// Makes a volume of the distances from a surface at the centres of voxels. They are exact up to three voxels from the
// surface, and signed by winding numbers: a point is inside if its winding number is at least one. Flat and small holes
// are closed by lids (closeBoundaries()). Wide curved holes are closed where the generalised winding number passes one
// half (WindingNumberFill.h), with distances of first order. Overlapping bodies become one, and walls within them
// vanish; a surface that is inside out encloses nothing.
//
// voxel: edge of a voxel, mm. alignedTo: the origin of a grid from which the volume's grid may differ by whole blocks
// only, mm; none: the sides of the part lie between voxels. Runs on all threads of the arena; O(area / voxel² + n log
// n). Errors: MeshError::NoTriangles, NumberNotFinite, ValueOutOfRange (for the voxel), VolumeErrors::TooFine (if an
// axis would have more voxels than a volume allows), TooLarge (for the memory that the system has left), NoVoxelInside,
// NothingInside, SurfaceIsLost, MaterialIsLost; Cancelled.
Result<SurfaceVolume> volumeOfSurface(const TriangleSoup& soup, double voxel, Progress progress = {},
                                      const std::optional<Vec3>& alignedTo = {});

// Least fraction of a solid's surface, and of its volume, that its voxels must keep.
inline constexpr double kLeastKept = 0.5;
// Fraction of the surface that voxels may lose without a warning, at sharp edges. A larger loss means lost walls.
inline constexpr double kThinShare = 1e-3;

// Default number of voxels along the largest extent of a surface, from which usualVoxel() computes the voxel size, mm.
inline constexpr double kUsualVoxels = 256.0;
double usualVoxel(const TriangleSoup& surface, double across = kUsualVoxels);

double surfaceArea(const TriangleSoup& soup);

// Returns the least number of blocks for a surface of this area, mm². The prediction is accurate to a third if the
// surface is smooth at the scale of a few voxels.
double predictedBlocks(double area, double voxel);
// Returns the memory of the volume of a surface with this area (mm²), bytes.
double predictedVolumeBytes(double area, double voxel);
// Returns the memory that volumeOfSurface() requires, bytes; wide holes require more. extent: size of the surface, mm.
double predictedMakingBytes(double area, const Vec3& extent, double voxel);
// Returns the time in s for making the volume and its surface on the threads of the arena, as an order of magnitude.
double predictedMakingSeconds(double area, double voxel);

}  // namespace handwheel
