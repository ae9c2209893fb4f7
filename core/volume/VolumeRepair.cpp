// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeRepair.h"

#include "mesh/simplify/Decimation.h"
#include "mesh/structure/MeshBuilder.h"
#include "proximity/SelfIntersection.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeToSurface.h"

namespace handwheel {
namespace {

// Fewer triangles, as long as none meet by that; else the mesh as it is.
HalfEdgeMesh reduced(const HalfEdgeMesh& mesh, std::size_t faces, Progress progress) {
  HalfEdgeMesh fewer = mesh;
  const DecimationReport report =
      decimate(fewer, {.faces = faces, .method = DecimationMethod::Quadric}, progress.part(0.0, 0.7));
  if (report.refusal != OpenMeshRefusal::None || report.cancelled) return mesh;
  const TriangleSoup soup = fewer.compact().soup;
  const auto pairs = selfIntersections(soup.points, soup.triangles, progress.part(0.7, 1.0), 1);
  return pairs && pairs->empty() ? fewer : mesh;
}

}  // namespace

Result<VolumeRepair> repairByVolume(const TriangleSoup& surface, const VolumeRepairOptions& options,
                                    Progress progress) {
  const Result<SurfaceVolume> made = volumeOfSurface(surface, options.voxel, progress.part(0.0, 0.4));
  if (!made) return made.error();
  const TriangleSoup sampled = surfaceOf(made->volume, progress.part(0.4, 0.5));
  VolumeRepair repair{buildMesh(sampled, progress.part(0.5, 0.6)).mesh, made->closedBoundaries,
                      sampled.triangles.size(), made->nearShare};
  if (options.isReduced && sampled.triangles.size() > surface.triangles.size() && !progress.cancelled())
    repair.mesh = reduced(repair.mesh, surface.triangles.size(), progress.part(0.6, 1.0));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return repair;
}

}  // namespace handwheel
