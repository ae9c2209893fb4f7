// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "mesh/structure/HalfEdgeMesh.h"
#include "mesh/structure/TriangleSoup.h"

#include <cstddef>

namespace handwheel {

// Options of the repair of a surface by a volume.
struct VolumeRepairOptions {
  double voxel = 0.0;     // mm
  double gaps = 0.0;      // mm; gaps that a ball of this radius cannot enter are filled (withoutGaps()); 0: none
  double within = 1.0;    // voxels, largest displacement of the surface by the reduction
  bool isReduced = true;  // reduces the triangles to about the number of the surface, as far as `within` allows
  NumberType numbers = NumberType::Float64;  // precision of the coordinates of the mesh
};

// A surface that was repaired by a volume.
struct VolumeRepair {
  HalfEdgeMesh mesh;                 // closed, manifold, oriented, free of self-intersections
  std::size_t closedBoundaries = 0;  // see SurfaceVolume
  std::size_t sampledTriangles = 0;  // triangles of the volume's surface before the reduction
  double nearShare = 0.0;            // see SurfaceVolume
  double filled = 0.0;               // mm³, volume of the filled gaps
  double keptDistance = 0.0;  // mm, largest distance found from the material-bounding parts of the surface to the mesh
};

// Replaces a surface by that of the volume that it encloses (He 2008, 4.1: the volume workflow). All defects are
// removed: holes, gaps, self-intersections, inner walls, non-manifold edges and vertices. Details below the size of a
// voxel vanish too, and sharp edges are cut off by up to half a voxel. Triangles are reduced by quadrics, as long as
// neither the sampled surface nor the original, where that bounds material, gets farther from the mesh than `within`
// voxels, and no triangles intersect. So with one voxel, only thinner walls are farther. A surface that is inside out
// is reversed. Errors: those of volumeOfSurface() and withoutGaps().
Result<VolumeRepair> repairByVolume(const TriangleSoup& surface, const VolumeRepairOptions& options,
                                    Progress progress = {});

// Returns the memory that the repair requires, without the hierarchy of triangles; bytes. area: mm². extent: mm.
double predictedRepairBytes(double area, const Vec3& extent, const VolumeRepairOptions& options);

}  // namespace handwheel
