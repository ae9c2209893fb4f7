// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "mesh/structure/HalfEdgeMesh.h"
#include "mesh/structure/TriangleSoup.h"
#include "volume/repair/ThinParts.h"

#include <cstddef>

namespace handwheel {

// Options of the repair of a surface by a volume.
struct VolumeRepairOptions {
  double voxel = 0.0;     // mm
  double gaps = 0.0;      // mm; gaps that a ball of this radius cannot enter are filled (withoutGaps()); 0: no filling
  double within = 1.0;    // largest displacement of the surface by the reduction, in voxels
  bool isReduced = true;  // reduces the triangles to about the number of the surface, as far as `within` allows
  NumberType numbers = NumberType::Float64;  // precision of the coordinates of the mesh
};

// A surface that was repaired by a volume.
struct VolumeRepair {
  HalfEdgeMesh mesh;                 // closed, manifold, oriented, free of self-intersections
  std::size_t closedBoundaries = 0;  // see SurfaceVolume
  std::size_t removedCrumbs = 0;     // see SurfaceVolume
  std::size_t sampledTriangles = 0;  // number of triangles of the volume's surface before the reduction
  double nearShare = 0.0;            // see SurfaceVolume
  double filled = 0.0;               // mm³, volume of the filled gaps
  double enclosed = 0.0;             // mm³ inside the surface with its holes closed; overlaps count several times
  ThinFigures walls, gaps;           // thin parts of the surface, and their fate
  double keptDistance = 0.0;  // mm, largest distance found from the material-bounding parts of the surface to the mesh
};

// Replaces a surface by that of the volume that it encloses (He 2008, 4.1: the volume workflow). All defects are
// removed: holes, gaps, self-intersections, inner walls, non-manifold edges and vertices. Details smaller than a voxel
// vanish, too, and sharp edges are cut off by up to half a voxel. Triangles are reduced by quadrics, as long as no
// triangles intersect and the distance to the mesh is at most `within` voxels. That distance is measured from the
// sampled surface, and from the original surface where it bounds material. So for a limit of one voxel, only walls
// thinner than a voxel are farther from the mesh. A surface that is inside out is reversed. Errors: the errors of
// volumeOfSurface() and withoutGaps().
Result<VolumeRepair> repairByVolume(const TriangleSoup& surface, const VolumeRepairOptions& options,
                                    Progress progress = {});

// Predicts the memory in bytes that the repair requires, without the search structure that measures distances from the
// surface (SurfaceDistance). area, extent: the surface's area, mm², and the size of its bounding box, mm.
double predictedRepairBytes(double area, const Vec3& extent, const VolumeRepairOptions& options);

}  // namespace handwheel
