// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeRepair.h"

#include "mesh/measure/Deviation.h"
#include "mesh/search/SurfaceDistance.h"
#include "mesh/simplify/Decimation.h"
#include "mesh/structure/MeshBuilder.h"
#include "proximity/SelfIntersection.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeToSurface.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace handwheel {
namespace {

// How far the original gets from the mesh at most, mm; none: cancelled.
std::optional<double> distanceFrom(const HalfEdgeMesh& mesh, const SurfaceDistance& original, Progress progress) {
  const SurfaceDistance surface(mesh, progress);
  const std::size_t samples = std::clamp<std::size_t>(2 * original.faces().size(), 5'000, 200'000);
  const Result<Deviation> measured = deviation(surface, original, {.samples = samples}, progress);
  if (!measured) return std::nullopt;
  return std::abs(measured->ofScan.farthest().distance);
}

// Takes triangles away from a mesh that was sampled.
class Reduction {
 public:
  // kept: what of the original is to stay within the distance.
  Reduction(const HalfEdgeMesh& sampled, const SurfaceDistance& kept, double within)
      : m_sampled(sampled), m_kept(kept), m_within(within) {}

  // The first of so many triangles, or twice, four times as many and so on, that is near enough; else all.
  VolumeRepair reduced(VolumeRepair repair, std::size_t faces, Progress progress) const {
    const std::size_t all = m_sampled.liveFaceCount();
    double done = 0.0;
    for (std::size_t wanted = std::max<std::size_t>(faces, 100); wanted < all && !progress.cancelled(); wanted *= 2) {
      const double next = 0.5 * (1.0 + done);
      if (attempt(wanted, repair, progress.part(done, next))) return repair;
      done = next;
    }
    return repair;
  }

 private:
  bool attempt(std::size_t faces, VolumeRepair& repair, Progress progress) const {
    HalfEdgeMesh fewer = m_sampled;
    const DecimationReport report =
        decimate(fewer, {.faces = faces, .method = DecimationMethod::Quadric}, progress.part(0.0, 0.5));
    if (report.refusal != OpenMeshRefusal::None || report.cancelled) return false;
    const std::optional<double> kept = distanceFrom(fewer, m_kept, progress.part(0.5, 0.6));
    // Where the sampled surface is farther itself, nothing can be nearer.
    if (!kept || *kept > std::max(m_within, repair.keptDistance)) return false;
    const std::optional<double> distance = largestDistance(fewer, m_sampled, progress.part(0.6, 0.7));
    if (!distance || *distance > m_within) return false;
    const TriangleSoup soup = fewer.compact().soup;
    const auto pairs = selfIntersections(soup.points, soup.triangles, progress.part(0.7, 1.0), 1);
    if (!pairs || !pairs->empty()) return false;
    repair.mesh = std::move(fewer);
    repair.keptDistance = *kept;
    return true;
  }

  const HalfEdgeMesh& m_sampled;
  const SurfaceDistance& m_kept;
  double m_within;
};

// The triangles of a surface that bound material.
HalfEdgeMesh keptOf(const TriangleSoup& surface, const std::vector<bool>& isKept) {
  TriangleSoup kept{surface.points, {}};
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    if (isKept[i]) kept.triangles.push_back(surface.triangles[i]);
  return buildMesh(kept).mesh;
}

}  // namespace

Result<VolumeRepair> repairByVolume(const TriangleSoup& surface, const VolumeRepairOptions& options,
                                    Progress progress) {
  const Result<SurfaceVolume> made = volumeOfSurface(surface, options.voxel, progress.part(0.0, 0.4));
  if (!made) return made.error();
  const TriangleSoup sampled = surfaceOf(made->volume, progress.part(0.4, 0.5));
  const HalfEdgeMesh mesh = buildMesh(sampled, progress.part(0.5, 0.55)).mesh;
  const SurfaceDistance kept(keptOf(surface, made->isKept), progress.part(0.55, 0.6));
  const std::optional<double> distance = kept.empty() ? 0.0 : distanceFrom(mesh, kept, progress.part(0.55, 0.6));
  if (progress.cancelled() || !distance) return Error{ErrorCode::Cancelled, {}, {}, {}};
  VolumeRepair repair{mesh, made->closedBoundaries, sampled.triangles.size(), made->nearShare, *distance};
  if (options.isReduced && !kept.empty() && sampled.triangles.size() > surface.triangles.size())
    repair = Reduction(mesh, kept, options.voxel)
                 .reduced(std::move(repair), surface.triangles.size(), progress.part(0.6, 1.0));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return repair;
}

}  // namespace handwheel
