// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "mesh/structure/TriangleSoup.h"
#include "volume/SparseVolume.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace handwheel {

// A volume made of a surface, with checks that it is the enclosed solid.
struct SurfaceVolume {
  SparseVolume volume;
  std::size_t closedBoundaries = 0;  // holes, gaps and turned faces
  // mm³, volume inside the surface closed by cones, from its triangles; overlaps count several times.
  double expected = 0.0;
  // Approximate fraction of the area bounding material that lies within a voxel of the volume's surface.
  double nearShare = 0.0;
  std::vector<Vec3> kept;  // mm, points all over the surface, where it certainly bounds material
};

// Samples the distance from a surface at the centres of voxels, exactly up to three voxels from it, and signs it by
// winding numbers: a point is inside if its winding number is at least one. Flat and small holes are closed by lids
// (closeBoundaries()), wide bent ones where the generalised winding number passes a half (WindingNumberFill.h), to
// which distances are of first order. Overlapping bodies become one, and walls within them vanish; a surface that is
// inside out encloses nothing.
//
// voxel: edge of a voxel, mm. alignedTo: the origin of a grid from which the volume's grid may differ by whole blocks
// only, mm; none: the sides of the part lie between voxels. On all threads of the arena; O(area / voxel² + n log n).
// Errors: MeshError::NoTriangles, NumberNotFinite, ValueOutOfRange (of the voxel), VolumeErrors::TooFine (more voxels
// along an axis than a volume has), TooLarge (for the memory that the system has left), NoVoxelInside, NothingInside,
// SurfaceIsLost, MaterialIsLost; Cancelled.
Result<SurfaceVolume> volumeOfSurface(const TriangleSoup& soup, double voxel, Progress progress = {},
                                      const std::optional<Vec3>& alignedTo = {});

// Least fraction of the surface and of the volume of a solid that its voxels must keep.
inline constexpr double kLeastKept = 0.5;
// Fraction of the surface that voxels may lose without a warning: the tips of edges. A larger loss means lost walls.
inline constexpr double kThinShare = 1e-3;

// Default number of voxels along the largest extent of a surface, and the voxel size that follows, mm.
inline constexpr double kUsualVoxels = 256.0;
double usualVoxel(const TriangleSoup& surface, double across = kUsualVoxels);

double surfaceArea(const TriangleSoup& soup);

// Returns the least number of blocks for a surface of this area, mm². Accurate to a third for surfaces that are smooth
// at the scale of a few voxels.
double predictedBlocks(double area, double voxel);
// Returns the memory of such a volume; bytes.
double predictedVolumeBytes(double area, double voxel);
// Returns the memory that volumeOfSurface() requires, without wide holes; bytes. extent: size of the surface, mm.
double predictedMakingBytes(double area, const Vec3& extent, double voxel);
// Returns the time for making the volume and its surface on the threads of the arena, as an order of magnitude; s.
double predictedMakingSeconds(double area, double voxel);

}  // namespace handwheel
