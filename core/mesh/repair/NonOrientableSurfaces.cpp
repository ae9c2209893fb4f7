// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/NonOrientableSurfaces.h"

#include "mesh/holes/HoleSequence.h"
#include "mesh/repair/CoincidentVertexSeparation.h"
#include "mesh/repair/ObstructedHoles.h"
#include "mesh/repair/SheetThickening.h"
#include "mesh/repair/intersections/SelfIntersectionRemoval.h"
#include "mesh/search/MovedFaces.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/OrientationReversal.h"
#include "mesh/structure/PositionTriangles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace handwheel {
namespace {

constexpr double kSlit = 0.1;      // share of the distance to the middle of the faces on one side
constexpr int kSmallerSlits = 10;  // number of halvings
constexpr std::size_t kMostLoops = 64;

// Returns the mesh as a file stores it, or only the given faces; faces beyond their slots were added to them.
struct Welded {
  Welded(const HalfEdgeMesh& mesh, const FaceSelection* only, std::size_t slots, Progress progress)
      : byPosition(trianglesOf(mesh, only, slots, progress.part(0.0, 0.6))),
        edges(byPosition.triangles, byPosition.classes.representative.size(), progress.part(0.6, 1.0)) {
    for (const Vertex v : byPosition.classes.representative) points.push_back(mesh.position(v));
  }

  bool hasOneSide(Progress progress) const {
    return !nonOrientableEdges(edges, byPosition.triangles, progress).empty();
  }

  static PositionTriangles trianglesOf(const HalfEdgeMesh& mesh, const FaceSelection* only, std::size_t slots,
                                       Progress progress) {
    PositionTriangles all(mesh, progress);
    for (Face f = 0; only && f < std::min(slots, all.triangles.size()); ++f) {
      if (!only->contains(f)) all.triangles[f] = {0, 0, 0};  // joins nothing
    }
    return all;
  }

  PositionTriangles byPosition;
  EdgeTable edges;
  std::vector<Vec3> points;
};

// Cuts along one cycle.
class LoopCutter {
 public:
  LoopCutter(HalfEdgeMesh& mesh, const Welded& welded, const OrientationReversingCycle& loop, NumberType numbers)
      : m_mesh(mesh), m_triangles(welded.byPosition.triangles), m_numbers(numbers) {
    for (const std::uint32_t h : loop.halfEdges) m_cut.insert(key(from(h), to(h)));
    for (const auto& [low, high] : m_cut) m_corners[low], m_corners[high];
    for (std::uint32_t c = 0; c < 3 * m_triangles.size(); ++c) {
      if (hasRepeatedVertex(m_triangles[c / 3])) continue;
      if (const auto it = m_corners.find(from(c)); it != m_corners.end()) it->second.push_back(c);
    }
  }

  // Returns false, without a change, if a side cannot be moved. Adds the vertices on both sides of the cut.
  bool cut(std::vector<Vertex>& vertices) {
    HalfEdgeMesh result = m_mesh;
    std::vector<Vertex> found;
    for (const auto& [point, corners] : m_corners) {
      for (const Side& fan : grouped(corners, true)) {
        std::vector<Side> sides = grouped(fan, false);
        if (sides.size() == 1) continue;
        std::stable_sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) { return angle(a) > angle(b); });
        found.push_back(result.from(sides[0].front()));  // stays where it is
        for (std::size_t i = 1; i < sides.size(); ++i) {
          if (!move(result, sides[i])) return false;
          found.push_back(result.from(sides[i].front()));
        }
      }
    }
    relink(result);
    m_mesh = std::move(result);
    vertices.insert(vertices.end(), found.begin(), found.end());
    return true;
  }

 private:
  using Side = std::vector<std::uint32_t>;  // connected corners around a point

  std::uint32_t from(std::uint32_t c) const { return m_triangles[c / 3][c % 3]; }
  std::uint32_t to(std::uint32_t c) const { return m_triangles[c / 3][(c % 3 + 1) % 3]; }
  std::uint32_t before(std::uint32_t c) const { return m_triangles[c / 3][(c % 3 + 2) % 3]; }
  static std::pair<std::uint32_t, std::uint32_t> key(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

  // Groups the corners that are connected through edges with two faces, optionally across the cut too.
  std::vector<Side> grouped(const std::vector<std::uint32_t>& corners, bool acrossCut) const {
    std::map<std::uint32_t, std::vector<std::size_t>> byEdge;  // by the point at the other end
    for (std::size_t i = 0; i < corners.size(); ++i) {
      byEdge[to(corners[i])].push_back(i);
      byEdge[before(corners[i])].push_back(i);
    }
    std::vector<std::size_t> group(corners.size());
    for (std::size_t i = 0; i < group.size(); ++i) group[i] = i;
    const auto find = [&](std::size_t i) {
      while (group[i] != i) i = group[i] = group[group[i]];
      return i;
    };
    for (const auto& [other, on] : byEdge) {
      const bool isJoined = on.size() == 2 && (acrossCut || !m_cut.contains(key(from(corners[on[0]]), other)));
      if (isJoined) group[find(on[0])] = find(on[1]);
    }
    std::map<std::size_t, Side> sides;
    for (std::size_t i = 0; i < corners.size(); ++i) sides[find(i)].push_back(corners[i]);
    std::vector<Side> result;
    result.reserve(sides.size());
    for (auto& entry : sides) result.push_back(std::move(entry.second));
    return result;
  }

  double angle(const Side& side) const {
    double sum = 0.0;
    for (const std::uint32_t c : side) {
      const TrianglePoints p = m_mesh.points(c / 3);
      const Vec3 u = p[(c % 3 + 1) % 3] - p[c % 3], v = p[(c % 3 + 2) % 3] - p[c % 3];
      sum += std::atan2(u.cross(v).norm(), u.dot(v));
    }
    return sum;
  }

  // Gives the side a separate vertex, moved a short distance into its faces.
  bool move(HalfEdgeMesh& mesh, const Side& side) const {
    const Vec3 position = mesh.position(mesh.from(side.front()));
    Vec3 middle = Vec3::Zero();
    for (const std::uint32_t c : side) {
      const TrianglePoints p = mesh.points(c / 3);
      middle += ((p[0] - position) + (p[1] - position) + (p[2] - position)) / (3.0 * static_cast<double>(side.size()));
    }
    double step = kSlit;
    for (int i = 0; i < kSmallerSlits; ++i, step *= 0.5) {
      const Vec3 moved = rounded(Vec3(position + step * middle), m_numbers);
      if (moved == position || !mayStandAt(mesh, side, moved)) continue;
      const Vertex v = mesh.addVertex(moved);
      for (const std::uint32_t c : side) mesh.setCorner(c, v);
      return true;
    }
    return false;
  }

  static bool mayStandAt(const HalfEdgeMesh& mesh, const Side& side, const Vec3& moved) {
    return std::all_of(side.begin(), side.end(), [&](std::uint32_t c) {
      const TrianglePoints is = mesh.points(c / 3);
      TrianglePoints will = is;
      will[c % 3] = moved;
      return mayBecome(is, will);
    });
  }

  HalfEdgeMesh& m_mesh;
  const std::vector<Triangle>& m_triangles;
  const NumberType m_numbers;
  std::set<std::pair<std::uint32_t, std::uint32_t>> m_cut;
  std::map<std::uint32_t, std::vector<std::uint32_t>> m_corners;  // corners around each point of the cycle
};

// Returns the loops that consist only of cut edges.
std::vector<BoundaryLoop> slitsOf(const HalfEdgeMesh& mesh, const std::vector<Vertex>& cut, Progress progress) {
  const auto isCut = [&](const Vec3& p) {
    return std::any_of(cut.begin(), cut.end(), [&](Vertex v) { return mesh.position(v) == p; });
  };
  std::vector<BoundaryLoop> slits;
  for (BoundaryLoop& loop : findBoundaryLoops(mesh, progress)) {
    const bool isSlit = std::all_of(loop.halfEdges.begin(), loop.halfEdges.end(),
                                    [&](HalfEdge h) { return isCut(mesh.position(mesh.from(h))); });
    if (isSlit) slits.push_back(std::move(loop));
  }
  return slits;
}

void closeSlits(HalfEdgeMesh& mesh, const std::vector<Vertex>& cut, const FillOptions& options, Progress progress) {
  fillHoles(mesh, slitsOf(mesh, cut, progress.part(0.0, 0.1)), options, progress.part(0.1, 0.4));
  if (progress.cancelled()) return;
  std::vector<ObstructedHole> left;
  for (BoundaryLoop& loop : slitsOf(mesh, cut, progress.part(0.4, 0.5))) left.push_back({std::move(loop), false});
  if (left.empty() || progress.cancelled()) return;
  closeObstructedHoles(mesh, left, options, defaultSheetThickness(mesh), progress.part(0.5, 0.9));
  if (!separateCoincidentVertices(mesh, options.numbers, progress.part(0.9, 0.95)).empty())
    relink(mesh, progress.part(0.95, 1.0));
}

}  // namespace

NonOrientableCut cutNonOrientable(HalfEdgeMesh& mesh, double longest, NumberType numbers, Progress progress,
                                  const FaceSelection* only) {
  NonOrientableCut cut;
  const std::size_t slots = mesh.faceSlots();
  while (cut.loops < kMostLoops) {
    const double share = static_cast<double>(cut.loops) / static_cast<double>(kMostLoops);
    const Progress now = progress.part(share, share + 1.0 / static_cast<double>(kMostLoops));
    const Welded welded(mesh, only, slots, now.part(0.0, 0.4));
    if (now.cancelled()) break;
    cut.isTwoSided = !welded.hasOneSide(now.part(0.4, 0.6));
    if (cut.isTwoSided) break;
    const auto loop = shortestOrientationReversingCycle(welded.edges, welded.byPosition.triangles, welded.points,
                                                        longest, now.part(0.6, 1.0));
    if (!loop || !LoopCutter(mesh, welded, *loop, numbers).cut(cut.vertices)) break;
    ++cut.loops;
    if (loop->isOnBorder) cut.opened += loop->halfEdges.size();
  }
  std::sort(cut.vertices.begin(), cut.vertices.end());
  cut.vertices.erase(std::unique(cut.vertices.begin(), cut.vertices.end()), cut.vertices.end());
  return cut;
}

std::size_t closeNonOrientable(HalfEdgeMesh& mesh, const FillOptions& options, double longest,
                               BoundaryCuts boundaryCuts, Progress progress, const FaceSelection* only) {
  HalfEdgeMesh result = mesh;
  const NonOrientableCut cut = cutNonOrientable(result, longest, options.numbers, progress.part(0.0, 0.3), only);
  if (cut.loops == 0 || progress.cancelled()) return 0;
  const std::size_t crossings = countSelfIntersections(mesh, options.numbers, progress.part(0.3, 0.35));
  std::size_t allowed = countBadEdges(mesh, progress.part(0.35, 0.4));
  if (boundaryCuts == BoundaryCuts::Yes) allowed += 2 * cut.opened;
  closeSlits(result, cut.vertices, options, progress.part(0.4, 0.9));
  const bool isSound =
      !progress.cancelled() && countBadEdges(result, progress.part(0.9, 0.92)) <= allowed &&
      !Welded(result, only, mesh.faceSlots(), progress.part(0.92, 0.94)).hasOneSide(progress.part(0.94, 0.95)) &&
      countSelfIntersections(result, options.numbers, progress.part(0.95, 1.0)) <= crossings;
  if (!isSound || progress.cancelled()) return 0;
  mesh = std::move(result);
  return cut.loops;
}

}  // namespace handwheel
