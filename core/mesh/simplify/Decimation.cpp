// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/simplify/Decimation.h"

#include "mesh/search/LargestDistance.h"
#include "mesh/simplify/Decimator.h"
#include "mesh/simplify/QuadricDecimation.h"
#include "mesh/structure/WorkingScale.h"

#include <algorithm>

namespace handwheel {
namespace {

// Share of the error limit used in the first tries, and that of each further try relative to the previous one.
constexpr double kFirstShare = 0.95, kNextShare = 0.85;
constexpr int kTriesAtFirstShare = 3, kTries = 7;
// The same for vertices that are inserted where a try fails: between them the surface is as it was.
constexpr double kInsertedShare = 0.985;
constexpr int kMostInsertions = 12;  // rounds of each try, which are short

std::size_t removeDegenerate(HalfEdgeMesh& mesh) {
  std::size_t removed = 0;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f) || mesh.isProper(f)) continue;
    mesh.removeFace(f);
    ++removed;
  }
  return removed;
}

// Collects the vertices of the faces within reach of these positions. The result is invalid once cancelled.
void addVerticesNear(const SurfaceDistance& surface, const std::vector<Vec3>& positions, double reach,
                     std::vector<Vertex>& vertices, const Progress& progress) {
  for (const Vec3& p : positions) {
    if (progress.cancelled()) return;
    const Box box(p - Vec3::Constant(reach), p + Vec3::Constant(reach));
    surface.hierarchy().forEachInBox(box, [&](std::uint32_t triangle) {
      for (const Vertex v : surface.mesh().triangle(surface.faces()[triangle])) vertices.push_back(v);
      return true;
    });
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
}

// Inserts a vertex between the surfaces at each of these positions. Returns the regions that have to be proven again:
// boxes of the faces that were changed, and of the positions where nothing could be inserted. Returns no regions if
// nothing was changed. The result is invalid once cancelled.
std::vector<Box> insertVertices(Decimator& decimator, const SurfaceDistance& made, const SurfaceDistance& original,
                                const std::vector<Vec3>& positions, double error, const Progress& progress) {
  std::vector<Box> regions;
  bool isChanged = false;
  for (const Vec3& p : positions) {
    if (progress.cancelled()) return {};
    Box region(p);
    const auto here = made.hierarchy().nearest(p), there = original.hierarchy().nearest(p);
    // A vertex on the original is often too far from what is around it.
    for (const double share : {0.5, 0.3, 0.1, 0.03}) {
      const Vec3 between = here->point + share * (there->point - here->point);
      const auto changed = decimator.insert(made.faces()[here->triangle], here->point, between);
      if (!changed) continue;
      region.extend(*changed);
      isChanged = true;
      break;
    }
    regions.emplace_back(region.min().array() - error, region.max().array() + error);
  }
  return isChanged ? regions : std::vector<Box>();
}

// If a try exceeds the error between the points at which each collapse was checked, vertices are inserted there. If
// that is not enough, the next try does not change the surface there; the error of further ones is smaller, too, and
// the points are denser. The result is invalid once cancelled.
void decimateWithin(HalfEdgeMesh& mesh, const DecimationOptions& options, DecimationReport& report,
                    const Progress& progress) {
  const HalfEdgeMesh original = mesh;
  const SurfaceDistance surface(original, progress.part(0.0, 0.01));
  report.cancelled = progress.cancelled();
  if (report.cancelled) return;
  double error = kFirstShare * *options.error, reach = 2.0 * *options.error, from = 0.01;
  int density = 1;
  std::vector<Vertex> fixed;
  for (int i = 0; i < kTries; ++i, reach *= 2.0) {
    const double to = 0.5 * (from + 1.0);
    const Progress whole = progress.part(from, to);
    from = to;
    mesh = original;
    ErrorTracker check(original, error, density, whole.part(0.0, 0.05));
    Decimator decimator(mesh, options, {&check, fixed}, whole.part(0.05, 0.1));
    report.cancelled = !decimator.run(whole.part(0.1, 0.7));
    if (report.cancelled) return;
    check.setError(kInsertedShare * *options.error);
    DistanceProof proof;
    std::vector<Box> regions;
    for (int k = 0; k <= kMostInsertions; ++k) {
      const Progress proving = whole.part(k == 0 ? 0.7 : 0.9, k == 0 ? 0.9 : 1.0);
      const SurfaceDistance made(mesh, proving.part(0.0, 0.1));
      const auto next = proveWithin(made, surface, *options.error, proving.part(0.1, 1.0), regions);
      report.cancelled = progress.cancelled();
      if (report.cancelled || !next) return;
      const bool helped = k == 0 || next->beyond.size() < proof.beyond.size();
      proof = {std::max(proof.bound, next->bound), next->beyond};
      if (proof.isWithin(*options.error)) {
        report.largestDistance = proof.bound;
        return;
      }
      // Inserted vertices are additional triangles, and not on creases.
      if (!helped || options.faces > 0 || options.creaseAngle) break;
      regions = insertVertices(decimator, made, surface, proof.beyond, *options.error, progress);
      if (regions.empty()) break;
    }
    addVerticesNear(surface, proof.beyond, reach, fixed, whole);
    if (i < kTriesAtFirstShare - 1 && !proof.beyond.empty()) continue;
    error *= kNextShare;
    ++density;
  }
  mesh = original;
  report.largestDistance = 0.0;
}

DecimationReport decimateAtWorkingScale(HalfEdgeMesh& mesh, const DecimationOptions& options, const Progress& whole) {
  const HalfEdgeMesh original = mesh;
  const bool isMeasured = options.measureDistance && !options.error;
  const Progress progress = whole.part(0.0, isMeasured ? 0.7 : 1.0);
  DecimationReport report;
  report.facesBefore = mesh.liveFaceCount();
  report.removedDegenerate = removeDegenerate(mesh);
  if (options.method == DecimationMethod::Quadric) {
    report.refusal = decimateByQuadrics(mesh, options, progress);
    report.cancelled = progress.cancelled();
  } else if (options.error) {
    decimateWithin(mesh, options, report, progress);
  } else {
    report.cancelled = !Decimator(mesh, options, {}, progress.part(0.0, 0.05)).run(progress.part(0.05, 1.0));
  }
  if (isMeasured && !report.cancelled && report.refusal == OpenMeshRefusal::None) {
    report.largestDistance = largestDistance(mesh, original, whole.part(0.7, 1.0));
    report.cancelled = whole.cancelled();
  }
  if (report.cancelled || report.refusal != OpenMeshRefusal::None) mesh = original;
  report.facesAfter = mesh.liveFaceCount();
  return report;
}

}  // namespace

DecimationReport decimate(HalfEdgeMesh& mesh, const DecimationOptions& options, Progress progress) {
  WorkingScale scale(mesh);
  if (!scale.isNeeded()) return decimateAtWorkingScale(mesh, options, progress);
  HalfEdgeMesh work = mesh;
  scale.apply(work);
  DecimationOptions scaled = options;
  if (options.error) scaled.error = scale.toWork(*options.error);
  DecimationReport report = decimateAtWorkingScale(work, scaled, progress);
  if (report.cancelled || report.refusal != OpenMeshRefusal::None) return report;
  scale.undo(work);
  mesh = std::move(work);
  if (report.largestDistance) report.largestDistance = scale.fromWork(*report.largestDistance);
  return report;
}

}  // namespace handwheel
