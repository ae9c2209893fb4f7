// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/defects/MeshReport.h"

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/boundary/Islands.h"
#include "mesh/boundary/Stitching.h"
#include "mesh/defects/Defects.h"
#include "mesh/defects/DuplicateFaces.h"
#include "mesh/defects/InsideOutShells.h"
#include "mesh/defects/NonManifoldVertices.h"
#include "mesh/structure/DisjointSets.h"
#include "mesh/structure/EdgeTable.h"
#include "mesh/structure/FaceComponents.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/Weld.h"
#include "proximity/SelfIntersection.h"
#include "proximity/TriangleIntersection.h"

#include <algorithm>
#include <numeric>

namespace handwheel {
namespace {

// Edges and duplicates. shells: of triangles; those that share an edge with one other only are joined.
void countEdges(const TriangleSoup& soup, MeshReport& report, DisjointSets& shells, Progress progress) {
  report.oriented = true;
  const EdgeTable edges(soup.triangles, soup.points.size(), progress.part(0.0, 0.7));
  const auto count = [&](std::uint32_t low, std::uint32_t, std::span<const EdgeTable::Entry> run) {
    const auto forward = std::count_if(run.begin(), run.end(), [&](const EdgeTable::Entry& e) {
      return soup.triangles[e.halfEdge / 3][e.halfEdge % 3] == low;
    });
    const auto backward = static_cast<std::ptrdiff_t>(run.size()) - forward;
    report.boundaryEdges += run.size() == 1;
    report.nonManifoldEdges += run.size() > 2;
    report.inconsistentEdges += (forward > 1) + (backward > 1);
    report.oriented &= run.size() != 2 || forward == backward;  // with more faces, two disagree in any case
    if (run.size() == 2) shells.join(run[0].halfEdge / 3, run[1].halfEdge / 3);
  };
  edges.forEachEdge(count, progress.part(0.7, 0.9));
  for (const FaceGroup& group : equalFaces(soup.triangles, edges, progress.part(0.9, 1.0))) {
    report.duplicateFaces += group.faces.size() - 1;
  }
}

// Returns the volumes of the tetrahedra between the triangles and the origin, per shell.
std::vector<double> signedVolumes(const TriangleSoup& soup, DisjointSets& shells, const Vec3& origin) {
  std::vector<double> volumes(soup.triangles.size(), 0.0);
  for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
    const Triangle& t = soup.triangles[i];
    const Vec3 a = soup.points[t[0]] - origin;
    const Vec3 b = soup.points[t[1]] - origin;
    const Vec3 c = soup.points[t[2]] - origin;
    volumes[shells.root(i)] += a.dot(b.cross(c)) / 6.0;
  }
  return volumes;
}

// Counts properties that are no defect of the file by themselves, or take longer to find.
void countMore(const BuiltMesh& built, std::span<BoundaryLoop> loops, MeshReport& report, Progress progress) {
  report.reversedFaces = built.report.reversedFaces.size();
  report.nearVertices = stitchablePairs(built.mesh, tolerance::kNearWeld, progress.part(0.0, 0.5)).size();
  const std::vector<Component> components = findComponents(built.mesh, progress.part(0.5, 0.8));
  report.debris = countDebris(components);
  if (components.size() < 2) return;
  report.nestedBodies = findNestedBodies(built.mesh, progress.part(0.8, 0.9)).size();
  countIslands(built.mesh, loops, progress.part(0.9, 1.0));
}

}  // namespace

std::vector<LoopReport> reportOn(std::span<const BoundaryLoop> loops) {
  std::vector<LoopReport> reports;
  for (const BoundaryLoop& loop : loops) {
    reports.push_back(
        {loop.id, loop.borderEdges, loop.length, loop.planarity, loop.area, loop.islands, loop.isSheetBoundary});
  }
  return reports;
}

MeshReport reportOn(const TriangleSoup& soup, SelfIntersections choice, Progress progress) {
  MeshReport report;
  const TriangleSoup welded = weld(soup, progress.part(0.0, 0.03));
  if (progress.cancelled()) return report;
  report.triangles = welded.triangles.size();
  report.vertices = welded.points.size();
  for (const Vec3& p : welded.points) report.box.extend(p);
  for (const Triangle& t : welded.triangles) {
    report.degenerateFaces += isDegenerate({welded.points[t[0]], welded.points[t[1]], welded.points[t[2]]});
  }
  DisjointSets shells(welded.triangles.size());
  countEdges(welded, report, shells, progress.part(0.03, 0.06));
  if (progress.cancelled()) return report;
  report.components = FaceComponents(welded.triangles, welded.points.size(), progress.part(0.06, 0.07)).count();
  if (progress.cancelled()) return report;
  report.nonManifoldVertices =
      findNonManifoldVertices(welded.triangles, welded.points.size(), progress.part(0.07, 0.1)).size();
  if (progress.cancelled()) return report;
  report.closed = report.triangles > 0 && report.boundaryEdges == 0;
  report.manifold = report.nonManifoldEdges == 0 && report.nonManifoldVertices == 0;
  const std::vector<double> volumes = signedVolumes(welded, shells, report.box.center());
  // The volumes of open shells depend on where they are taken from.
  const bool mayBeInsideOut =
      report.oriented &&
      (report.boundaryEdges > 0 || std::any_of(volumes.begin(), volumes.end(), [](double v) { return v < 0.0; }));
  const bool isWhole = choice == SelfIntersections::Count;
  if (report.boundaryEdges > 0 || mayBeInsideOut ||
      (isWhole && (report.inconsistentEdges > 0 || report.components > 1))) {
    const BuiltMesh built = buildMesh(welded, progress.part(0.1, 0.2));
    const HalfEdgeMesh& mesh = built.mesh;
    std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh, progress.part(0.2, 0.23));
    if (isWhole) countMore(built, loops, report, progress.part(0.23, 0.25));
    report.loops = reportOn(loops);
    if (mayBeInsideOut) report.insideOutBodies = findInsideOutShells(mesh, progress.part(0.25, 0.3)).size();
    report.oriented &= report.insideOutBodies == 0;
    if (progress.cancelled()) return report;
  }
  if (report.closed) report.volumeMm3 = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  progress.set(0.3);
  if (choice == SelfIntersections::Count) {
    const auto pairs = selfIntersections(welded.points, welded.triangles, progress.part(0.3, 1.0));
    if (pairs) report.selfIntersectingPairs = pairs->size();
  }
  progress.set(1.0);
  return report;
}

}  // namespace handwheel
