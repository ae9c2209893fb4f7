// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/VolumeRepair.h"

#include "mesh/search/LargestDistance.h"
#include "mesh/search/SurfaceDistance.h"
#include "mesh/simplify/Decimation.h"
#include "mesh/structure/MeshBuilder.h"
#include "proximity/SelfIntersection.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeOffset.h"
#include "volume/VolumeSampler.h"
#include "volume/surface/VolumeToSurface.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace handwheel {
namespace {

// Returns the largest distance of the points from the mesh, mm.
double distanceFrom(const HalfEdgeMesh& mesh, const std::vector<Vec3>& points, Progress progress) {
  const SurfaceDistance surface(mesh, progress);
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, points.size(), 256), 0.0,
      [&](const tbb::blocked_range<std::size_t>& range, double most) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
          if (const auto nearest = surface.from(points[i])) most = std::max(most, std::abs(nearest->distance));
        return most;
      },
      [](double a, double b) { return std::max(a, b); });
}

void roundTo(HalfEdgeMesh& mesh, NumberType numbers) {
  if (numbers == NumberType::Float64) return;
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v) mesh.setPosition(v, rounded(mesh.position(v), numbers));
}

// Takes triangles away from a mesh that was sampled.
class Reduction {
 public:
  // kept: points of the original that must stay within the distance.
  Reduction(const HalfEdgeMesh& sampled, const std::vector<Vec3>& kept, const VolumeRepairOptions& options)
      : m_sampled(sampled), m_kept(kept), m_within(options.within * options.voxel), m_numbers(options.numbers) {}

  // Returns the first near enough reduction to so many triangles, or twice, four times as many and so on; else all
  // triangles. Each is made from the next larger one, so that the triangles are reduced only once.
  VolumeRepair reduced(VolumeRepair repair, std::size_t faces, Progress progress) const {
    constexpr double kMaking = 0.6;  // share of the time
    std::vector<std::size_t> wanted;
    for (std::size_t each = std::max<std::size_t>(faces, 100); each < m_sampled.liveFaceCount(); each *= 2)
      wanted.push_back(each);
    std::vector<HalfEdgeMesh> made;
    made.reserve(wanted.size());
    double done = 0.0;
    for (auto each = wanted.rbegin(); each != wanted.rend(); ++each) {
      const double next = 0.5 * (kMaking + done);
      HalfEdgeMesh fewer = made.empty() ? m_sampled : made.back();
      const DecimationReport report =
          decimate(fewer, {.faces = *each, .method = DecimationMethod::Quadric}, progress.part(done, next));
      if (report.cancelled) return repair;
      if (report.refusal != OpenMeshRefusal::None) break;
      made.push_back(std::move(fewer));
      done = next;
    }
    done = kMaking;
    for (auto each = made.rbegin(); each != made.rend() && !progress.cancelled(); ++each) {
      const double next = 0.5 * (1.0 + done);
      if (takeIfNear(std::move(*each), repair, progress.part(done, next))) return repair;
      done = next;
    }
    return repair;
  }

 private:
  bool takeIfNear(HalfEdgeMesh fewer, VolumeRepair& repair, Progress progress) const {
    roundTo(fewer, m_numbers);
    const double kept = distanceFrom(fewer, m_kept, progress.part(0.0, 0.2));
    // The result cannot be nearer than the sampled surface itself.
    if (kept > std::max(m_within, repair.keptDistance)) return false;
    const std::optional<double> distance = largestDistance(fewer, m_sampled, progress.part(0.2, 0.5));
    if (!distance || *distance > m_within) return false;
    const TriangleSoup soup = fewer.compact().soup;
    const auto pairs = selfIntersections(soup.points, soup.triangles, progress.part(0.5, 1.0), 1);
    if (!pairs || !pairs->empty()) return false;
    repair.mesh = std::move(fewer);
    repair.keptDistance = kept;
    return true;
  }

  const HalfEdgeMesh& m_sampled;
  const std::vector<Vec3>& m_kept;
  double m_within;  // mm
  NumberType m_numbers;
};

// Returns the volume of a surface, or of the reversed surface if it encloses nothing: the orientation of an open
// surface is arbitrary.
Result<SurfaceVolume> volumeOfEitherSide(const TriangleSoup& surface, double voxel, Progress progress) {
  Result<SurfaceVolume> made = volumeOfSurface(surface, voxel, progress);
  if (made || made.error().code != VolumeErrors::NothingInside) return made;
  TriangleSoup back = surface;
  for (Triangle& t : back.triangles) std::swap(t[0], t[1]);
  return volumeOfSurface(back, voxel, progress);
}

// Fills gaps, and removes the kept points inside the filling. Returns its volume, mm³.
Result<double> fillGaps(SurfaceVolume& made, double radius, Progress progress) {
  if (radius == 0.0) return 0.0;
  Result<SparseVolume> closed = withoutGaps(made.volume, radius, progress);
  if (!closed) return closed.error();
  const VolumeSampler sampler(*closed);
  std::erase_if(made.kept, [&](const Vec3& p) { return sampler.depthAt(p).depth > 0.5 * closed->voxel(); });
  const double filled = closed->material() - made.volume.material();
  made.volume = std::move(*closed);
  return filled;
}

// Measures what became of thin walls and gaps in the triangles of the result. Gaps that were to be filled are left out.
void measureThinParts(VolumeRepair& repair, const ThinParts& thin, double filledBelow, const Progress& progress) {
  ThinParts left = thin;
  std::erase_if(left.gaps, [&](const ThinParts::Point& gap) { return gap.thickness < 2.0 * filledBelow; });
  if (left.walls.empty() && left.gaps.empty()) return;
  const SurfaceDistance surface(repair.mesh, progress);
  const auto isInside = [&](const Vec3& p) {
    const auto nearest = surface.from(p);
    return nearest && nearest->distance < 0.0;
  };
  repair.walls = thinFigures(left, ThinKind::Walls, isInside);
  repair.gaps = thinFigures(left, ThinKind::Gaps, isInside);
}

}  // namespace

Result<VolumeRepair> repairByVolume(const TriangleSoup& surface, const VolumeRepairOptions& options,
                                    Progress progress) {
  Result<SurfaceVolume> made = volumeOfEitherSide(surface, options.voxel, progress.part(0.0, 0.2));
  if (!made) return made.error();
  const Result<double> filled = fillGaps(*made, options.gaps, progress.part(0.2, 0.4));
  if (!filled) return filled.error();
  const TriangleSoup sampled = surfaceOf(made->volume, progress.part(0.4, 0.5));
  HalfEdgeMesh mesh = buildMesh(sampled, progress.part(0.5, 0.55)).mesh;
  roundTo(mesh, options.numbers);
  VolumeRepair repair{mesh,
                      made->closedBoundaries,
                      made->removedCrumbs,
                      sampled.triangles.size(),
                      made->nearShare,
                      *filled,
                      made->expected,
                      {},
                      {},
                      distanceFrom(mesh, made->kept, progress.part(0.55, 0.6))};
  if (options.isReduced && sampled.triangles.size() > surface.triangles.size() && !progress.cancelled())
    repair = Reduction(mesh, made->kept, options)
                 .reduced(std::move(repair), surface.triangles.size(), progress.part(0.6, 0.95));
  measureThinParts(repair, made->thin, options.gaps, progress.part(0.95, 1.0));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return repair;
}

// Gaps are filled beside the volume that is made by then.
double predictedRepairBytes(double area, const Vec3& extent, const VolumeRepairOptions& options) {
  const double making = predictedMakingBytes(area, extent, options.voxel);
  if (options.gaps == 0.0) return making;
  const double filling = predictedOffsetBytes(predictedBlocks(area, options.voxel));
  return std::max(making, filling + predictedVolumeBytes(area, options.voxel));
}

}  // namespace handwheel
