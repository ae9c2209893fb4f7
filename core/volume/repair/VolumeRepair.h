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
  double gaps = 0.0;      // mm: what a ball of this radius does not get into is filled (withoutGaps()); 0: nothing
  double within = 1.0;    // voxels that the surface may be moved by for it
  bool isReduced = true;  // to about as many triangles as the surface had, or as keep the distances below
  NumberType numbers = NumberType::Float64;  // what the coordinates of the mesh are rounded to
};

// A surface that was repaired by a volume.
struct VolumeRepair {
  HalfEdgeMesh mesh;                 // closed, manifold, oriented, free of self-intersections
  std::size_t closedBoundaries = 0;  // as in SurfaceVolume
  std::size_t sampledTriangles = 0;  // of the volume's surface, before any were taken away
  double nearShare = 0.0;            // as in SurfaceVolume
  double filled = 0.0;               // mm³, of gaps
  double keptDistance = 0.0;         // mm, the largest found from what of the surface bounds material to the mesh
};

// Replaces a surface by that of the volume that it encloses (He 2008, 4.1: the volume workflow). All defects go: holes,
// gaps, self-intersections, walls inside, whatever is not manifold. Details below the size of a voxel go too, and sharp
// edges are cut off by up to half a voxel. Triangles are taken away by quadrics, as far as nothing of the sampled
// surface, nor of the original where that bounds material, gets farther from the mesh than so many voxels, and none
// meet. So with one voxel only walls that are thinner are farther. A surface that is inside out is turned over. Errors:
// those of volumeOfSurface() and withoutGaps().
Result<VolumeRepair> repairByVolume(const TriangleSoup& surface, const VolumeRepairOptions& options,
                                    Progress progress = {});

// What that asks the system for, of a surface of this area, mm², and extent, mm, but for its hierarchy of triangles;
// bytes.
double predictedRepairBytes(double area, const Vec3& extent, const VolumeRepairOptions& options);

}  // namespace handwheel
