// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeRepair.h"

#include "mesh/measure/Deviation.h"
#include "mesh/simplify/Decimation.h"
#include "mesh/structure/MeshBuilder.h"
#include "proximity/SelfIntersection.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeToSurface.h"

#include <algorithm>
#include <optional>

namespace handwheel {
namespace {

// The mesh with fewer triangles where it stays within this distance and none meet by that; else none.
std::optional<HalfEdgeMesh> reducedTo(std::size_t faces, const HalfEdgeMesh& mesh, double within, Progress progress) {
  HalfEdgeMesh fewer = mesh;
  const DecimationReport report =
      decimate(fewer, {.faces = faces, .method = DecimationMethod::Quadric}, progress.part(0.0, 0.5));
  if (report.refusal != OpenMeshRefusal::None || report.cancelled) return std::nullopt;
  const std::optional<double> distance = largestDistance(fewer, mesh, progress.part(0.5, 0.7));
  if (!distance || *distance > within) return std::nullopt;
  const TriangleSoup soup = fewer.compact().soup;
  const auto pairs = selfIntersections(soup.points, soup.triangles, progress.part(0.7, 1.0), 1);
  if (!pairs || !pairs->empty()) return std::nullopt;
  return fewer;
}

// Fewer triangles: as many as wanted, or twice, four times as many, and so on.
HalfEdgeMesh reduced(const HalfEdgeMesh& mesh, std::size_t faces, double within, Progress progress) {
  const std::size_t all = mesh.liveFaceCount();
  double done = 0.0;
  for (std::size_t wanted = std::max<std::size_t>(faces, 100); wanted < all && !progress.cancelled(); wanted *= 2) {
    const double next = 0.5 * (1.0 + done);
    if (auto fewer = reducedTo(wanted, mesh, within, progress.part(done, next))) return std::move(*fewer);
    done = next;
  }
  return mesh;
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
    repair.mesh = reduced(repair.mesh, surface.triangles.size(), options.voxel, progress.part(0.6, 1.0));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return repair;
}

}  // namespace handwheel
