// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/simplify/Decimation.h"

#include "mesh/search/DistanceBound.h"
#include "mesh/search/LargestDistance.h"
#include "mesh/simplify/Decimator.h"
#include "mesh/simplify/QuadricDecimation.h"
#include "mesh/structure/WorkingScale.h"

#include <algorithm>

namespace handwheel {
namespace {

// Share of the error limit used in the first try, and that of each further try relative to the previous one.
constexpr double kFirstShare = 0.95, kNextShare = 0.95;
constexpr int kTries = 6;

std::size_t removeDegenerate(HalfEdgeMesh& mesh) {
  std::size_t removed = 0;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f) || mesh.isProper(f)) continue;
    mesh.removeFace(f);
    ++removed;
  }
  return removed;
}

// Tests if each surface is within the error of the other, and collects the points where not.
Within isWithin(const SurfaceDistance& a, const SurfaceDistance& b, double error, std::vector<Vec3>& beyond,
                const Progress& progress) {
  std::vector<Vec3> beyondOther;
  const Within one = liesWithin(a, b, error, progress.part(0.0, 0.6), &beyond);
  const Within other = liesWithin(b, a, error, progress.part(0.6, 1.0), &beyondOther);
  beyond.insert(beyond.end(), beyondOther.begin(), beyondOther.end());
  if (one == Within::No || other == Within::No) return Within::No;
  return other == Within::Yes ? one : other;
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

// If a try exceeds the error between the points at which each collapse was checked, the next one does not change the
// surface there, and checks more points elsewhere. The result is invalid once cancelled.
void decimateWithin(HalfEdgeMesh& mesh, const DecimationOptions& options, DecimationReport& report,
                    const Progress& progress) {
  const HalfEdgeMesh original = mesh;
  const SurfaceDistance surface(original, progress.part(0.0, 0.01));
  report.cancelled = progress.cancelled();
  if (report.cancelled) return;
  double error = kFirstShare * *options.error, reach = 2.0 * *options.error, from = 0.01;
  std::vector<Vertex> fixed;
  for (int i = 0; i < kTries; ++i, error *= kNextShare, reach *= 2.0) {
    const double to = 0.5 * (from + 1.0);
    const Progress whole = progress.part(from, to);
    from = to;
    mesh = original;
    ErrorTracker check(original, error, i + 1, whole.part(0.0, 0.05));
    report.cancelled = !Decimator(mesh, options, {&check, fixed}, whole.part(0.05, 0.1)).run(whole.part(0.1, 0.6));
    if (report.cancelled) return;
    std::vector<Vec3> beyond;
    const SurfaceDistance made(mesh, whole.part(0.6, 0.65));
    const Within within = isWithin(made, surface, *options.error, beyond, whole.part(0.65, 0.8));
    report.cancelled = progress.cancelled();
    if (report.cancelled) return;
    if (within == Within::No) {
      addVerticesNear(surface, beyond, reach, fixed, whole);
      continue;
    }
    const std::optional<double> bound = largestDistance(made, surface, whole.part(0.8, 1.0));
    report.cancelled = progress.cancelled();
    if (report.cancelled) return;
    // Either proves it.
    if (within != Within::Yes && !(bound && *bound <= *options.error)) continue;
    report.largestDistance = std::min(bound.value_or(*options.error), *options.error);
    return;
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
