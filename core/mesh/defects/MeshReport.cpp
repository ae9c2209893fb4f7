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
#include "mesh/structure/FaceNormal.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/PositionKey.h"
#include "mesh/structure/Weld.h"
#include "mesh/structure/WorkingScale.h"
#include "proximity/SelfIntersection.h"
#include "proximity/TriangleIntersection.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace handwheel {
namespace {

// Both sides of each triangle, joined across edges with two triangles. A piece is one-sided if that joins its sides.
class TwoSides {
 public:
  explicit TwoSides(std::size_t triangles)
      : m_triangles(static_cast<std::uint32_t>(triangles)), m_sides(2 * triangles) {}

  void join(std::uint32_t a, std::uint32_t b, bool isConsistent) {
    m_sides.join(a, isConsistent ? b : b + m_triangles);
    m_sides.join(a + m_triangles, isConsistent ? b + m_triangles : b);
  }

  std::size_t countOneSided(DisjointSets& shells) {
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < m_triangles; ++i) {
      if (shells.root(i) == i && m_sides.root(i) == m_sides.root(i + m_triangles)) ++count;
    }
    return count;
  }

 private:
  std::uint32_t m_triangles;
  DisjointSets m_sides;
};

// Edges and duplicates. shells: of triangles; those that share an edge with one other only are joined.
void countEdges(const TriangleSoup& soup, MeshReport& report, DisjointSets& shells, Progress progress) {
  report.oriented = true;
  TwoSides sides(soup.triangles.size());
  long edgeCount = 0;
  std::vector<bool> isUsed(soup.points.size(), false);
  for (const Triangle& t : soup.triangles)
    for (const std::uint32_t v : t) isUsed[v] = true;
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
    ++edgeCount;
    if (run.size() != 2) return;
    shells.join(run[0].halfEdge / 3, run[1].halfEdge / 3);
    sides.join(run[0].halfEdge / 3, run[1].halfEdge / 3, forward == backward);
  };
  edges.forEachEdge(count, progress.part(0.7, 0.9));
  report.oneSidedPieces = sides.countOneSided(shells);
  report.eulerCharacteristic = static_cast<long>(std::count(isUsed.begin(), isUsed.end(), true)) - edgeCount +
                               static_cast<long>(soup.triangles.size());
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

// Joins the loops that one-sided surfaces were cut into: those that follow a cut and share an open vertex.
std::vector<LoopReport> joinedLoops(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops) {
  std::vector<LoopReport> reports = reportOn(loops);
  DisjointSets joined(loops.size());
  std::map<PointKey, std::uint32_t> loopAt;
  for (std::uint32_t i = 0; i < loops.size(); ++i) {
    if (loops[i].halfEdges.size() == loops[i].borderEdges) continue;
    for (const Vec3& p : loopPoints(mesh, loops[i])) {
      const auto [at, isNew] = loopAt.emplace(positionKey(p), i);
      if (!isNew) joined.join(i, at->second);
    }
  }
  std::map<std::uint32_t, std::size_t> first;
  std::vector<LoopReport> result;
  for (std::uint32_t i = 0; i < loops.size(); ++i) {
    const auto [at, isNew] = first.emplace(joined.root(i), result.size());
    if (isNew) {
      result.push_back(reports[i]);
      continue;
    }
    LoopReport& whole = result[at->second];
    whole.edges += reports[i].edges;
    whole.lengthMm += reports[i].lengthMm;
    whole.areaMm2 = std::max(whole.areaMm2, reports[i].areaMm2);
    whole.planarity = std::max(whole.planarity, reports[i].planarity);
    whole.isSheetBoundary |= reports[i].isSheetBoundary;
  }
  return result;
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

namespace {

MeshReport reportAtWorkingScale(const TriangleSoup& soup, SelfIntersections choice, const Progress& progress) {
  MeshReport report;
  const TriangleSoup welded = weld(soup, progress.part(0.0, 0.03));
  if (progress.cancelled()) return report;
  report.triangles = welded.triangles.size();
  report.vertices = welded.points.size();
  for (const Vec3& p : welded.points) report.box.extend(p);
  for (const Triangle& t : welded.triangles) {
    const TrianglePoints corners{welded.points[t[0]], welded.points[t[1]], welded.points[t[2]]};
    report.degenerateFaces += isDegenerate(corners);
    report.areaMm2 += handwheel::areaOf(corners);
  }
  DisjointSets shells(welded.triangles.size());
  countEdges(welded, report, shells, progress.part(0.03, 0.06));
  const bool doNeighboursAgree = report.oriented;
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
    report.loops = report.oneSidedPieces > 0 ? joinedLoops(mesh, loops) : reportOn(loops);
    if (mayBeInsideOut) report.insideOutBodies = findInsideOutShells(mesh, progress.part(0.25, 0.3)).size();
    report.oriented &= report.insideOutBodies == 0;
    if (progress.cancelled()) return report;
  }
  if (report.closed && report.oneSidedPieces == 0 && doNeighboursAgree)
    report.volumeMm3 = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  progress.set(0.3);
  if (choice == SelfIntersections::Count) {
    const auto pairs = selfIntersections(welded.points, welded.triangles, progress.part(0.3, 1.0));
    if (pairs) report.selfIntersectingPairs = pairs->size();
  }
  progress.set(1.0);
  return report;
}

}  // namespace

MeshReport reportOn(const TriangleSoup& soup, SelfIntersections choice, Progress progress) {
  Box box;
  for (const Vec3& p : soup.points) {
    if (p.allFinite()) box.extend(p);
  }
  const WorkingScale scale(box);
  if (!scale.isNeeded()) return reportAtWorkingScale(soup, choice, progress);
  TriangleSoup work = soup;
  for (Vec3& p : work.points) p = scale.toWork(p);
  MeshReport report = reportAtWorkingScale(work, choice, progress);
  for (LoopReport& loop : report.loops) {
    loop.lengthMm = scale.fromWork(loop.lengthMm);
    loop.areaMm2 = scale.fromWork(loop.areaMm2, 2);
  }
  report.areaMm2 = scale.fromWork(report.areaMm2, 2);
  if (report.volumeMm3) report.volumeMm3 = scale.fromWork(*report.volumeMm3, 3);
  report.box = box;
  return report;
}

}  // namespace handwheel
