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
  double expected = 0.0;   // mm³ inside the surface closed by cones, by its triangles; of overlaps each counts
  double nearShare = 0.0;  // of the area that bounds material, about: what is near the volume's surface
                           // within a voxel of it
  std::vector<Vec3> kept;  // mm, places on the surface that certainly bound material, all over it
};

// Samples the distance from a surface at the centres of voxels, exactly up to three voxels from it, and signs it by
// winding numbers: inside is what it goes round at least once. Flat and small holes are closed by lids
// (closeBoundaries()), wide bent ones where the generalised winding number passes a half (WindingNumberFill.h), to
// which distances are of first order. Overlapping bodies become one, and walls within them vanish; a surface that is
// inside out encloses nothing.
//
// voxel: edge of a voxel, mm. alignedTo: the origin of a grid that it is to share but for whole blocks, mm; none: sides
// of the part lie between voxels. On all threads of the arena; O(area / voxel² + n log n). Errors:
// MeshError::NoTriangles, NumberNotFinite, ValueOutOfRange (of the voxel), VolumeErrors::TooFine (more voxels along an
// axis than a volume has), TooLarge (for the memory that the system has left), NoVoxelInside, NothingInside,
// SurfaceIsLost, MaterialIsLost; Cancelled.
Result<SurfaceVolume> volumeOfSurface(const TriangleSoup& soup, double voxel, Progress progress = {},
                                      const std::optional<Vec3>& alignedTo = {});

// The least share of what bounds a solid, and of what is in it, that is kept where voxels stand for it at all.
inline constexpr double kLeastKept = 0.5;
// The share of its surface that voxels may lose without a word: the tips of edges. More were walls.
inline constexpr double kThinShare = 1e-3;

// The voxel for a surface where a person chooses none: so many along its largest extent; mm.
inline constexpr double kUsualVoxels = 256.0;
double usualVoxel(const TriangleSoup& surface, double across = kUsualVoxels);

double surfaceArea(const TriangleSoup& soup);

// The blocks that a surface of this area, mm², is going to take at least. Within a third for surfaces that are smooth
// at the scale of a few voxels.
double predictedBlocks(double area, double voxel);
// The memory of the volume then; bytes.
double predictedVolumeBytes(double area, double voxel);
// What volumeOfSurface() asks the system for, but for wide holes; bytes. extent: of the surface, mm.
double predictedMakingBytes(double area, const Vec3& extent, double voxel);
// How long that and the triangles of its surface take on the threads of the arena, by its order of magnitude; s.
double predictedMakingSeconds(double area, double voxel);

}  // namespace handwheel
