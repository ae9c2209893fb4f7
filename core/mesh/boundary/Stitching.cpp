// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/Stitching.h"

#include "mesh/boundary/BorderVertices.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/MeshBuilder.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

namespace handwheel {
namespace {

// Edges are looked along in pieces no longer than this share of the diagonal.
constexpr double kLongestPiece = 1.0 / 32.0;

struct Openness {
  std::size_t border = 0;
  std::size_t nonManifold = 0;

  bool improvesOn(const Openness& before) const { return border < before.border && nonManifold <= before.nonManifold; }
};

Openness measure(const HalfEdgeMesh& mesh, const BuildReport& report) {
  Openness o;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) o.border += mesh.isBorder(h);
  o.nonManifold = report.nonManifoldEdges + report.unpairedHalfEdges;
  return o;
}

bool isIn(const std::vector<bool>& set, Vertex v) {
  return v < set.size() && set[v];
}

using Pairs = std::vector<std::pair<Vertex, Vertex>>;

// How often the mesh is linked anew to find the pairs that may be merged, where not all may.
constexpr int kMostTrials = 64;

// Moves each vertex of a near pair onto the one with the smaller number.
std::vector<Vertex> merge(HalfEdgeMesh& mesh, const Pairs& pairs) {
  std::vector<Vertex> moved;
  std::map<Vertex, Vertex> onto;
  for (const auto& [a, b] : pairs) {
    const auto target = onto.find(a);
    const Vertex goal = target == onto.end() ? a : target->second;
    if (goal == b || !onto.emplace(b, goal).second) continue;
    const Vec3 p = mesh.position(goal);
    mesh.setPosition(b, p);
    moved.push_back(b);
  }
  return moved;
}

// Splits a border edge at a place: its face (a b c) keeps (a m c), the new face is (m b c). Only what is border and
// what is not stays true; the mesh must be relinked afterwards.
void splitAt(HalfEdgeMesh& mesh, HalfEdge h, const Vec3& p) {
  const HalfEdge hn = HalfEdgeMesh::next(h);
  const Vertex b = mesh.to(h), c = mesh.to(hn);
  const HalfEdge behind = mesh.opposite(hn);
  const Vertex m = mesh.addVertex(p);
  mesh.setCorner(hn, m);
  const Face f = mesh.addFace({m, b, c});
  mesh.setOpposite(3 * f + 1, behind);
  mesh.pair(hn, 3 * f + 2);
}

// The position of a border vertex strictly inside the edge and within reach of it, nearest to its middle.
std::optional<Vec3> vertexOnEdge(const HalfEdgeMesh& mesh, HalfEdge h, const BorderVertices& vertices, double diagonal,
                                 double nearWeld) {
  const Vec3 a = mesh.position(mesh.from(h)), b = mesh.position(mesh.to(h));
  const Vec3 d = b - a;
  const double length = d.stableNorm();
  if (length == 0.0) return std::nullopt;
  const double reach = std::min(nearWeld * diagonal, tolerance::kNearWeldEdge * length);
  const Vec3& apex = mesh.position(mesh.from(HalfEdgeMesh::previous(h)));
  std::optional<Vec3> best;
  double bestOffset = 0.5;
  const auto consider = [&](Vertex v) {
    const Vec3& p = mesh.position(v);
    const double t = (p - a).dot(d) / (length * length);
    if (t * length <= reach || (1.0 - t) * length <= reach) return;
    if ((p - (a + t * d)).norm() > reach || std::abs(t - 0.5) > bestOffset) return;
    if (isDegenerate({a, p, apex}) || isDegenerate({p, b, apex})) return;
    bestOffset = std::abs(t - 0.5);
    best = p;
  };
  // In pieces: the box of a long slanting edge would hold much of the model.
  const auto pieces = static_cast<int>(std::ceil(length / (kLongestPiece * diagonal)));
  for (int i = 0; i < pieces; ++i) {
    const Vec3 begin = a + double(i) / pieces * d, end = a + double(i + 1) / pieces * d;
    const Vec3 slack = Vec3::Constant(reach);
    vertices.forEachInBox(Box(begin.cwiseMin(end) - slack, begin.cwiseMax(end) + slack), consider);
  }
  return best;
}

std::size_t splitTJunctions(HalfEdgeMesh& mesh, const std::vector<bool>& fixed, Progress progress, double nearWeld) {
  const BorderVertices vertices(mesh, fixed, progress.part(0.0, 0.3));
  const double diagonal = modelDiagonal(mesh);
  std::size_t splits = 0;
  const std::size_t limit = 4 * vertices.size();  // each vertex splits few edges; a bound against endless splitting
  const std::size_t most = mesh.halfEdgeSlots() + 3 * limit;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots() && splits < limit; ++h) {
    if (!pollProgress(h, most, progress.part(0.3, 1.0))) break;
    while (splits < limit && mesh.isBorder(h)) {
      if (progress.cancelled()) return splits;  // many may lie near a long edge
      if (isIn(fixed, mesh.from(h)) || isIn(fixed, mesh.to(h))) break;
      const std::optional<Vec3> p = vertexOnEdge(mesh, h, vertices, diagonal, nearWeld);
      if (!p) break;
      // The new face's half-edges are visited later in this very loop.
      splitAt(mesh, h, *p);
      ++splits;
    }
  }
  return splits;
}

}  // namespace

std::vector<Vertex> stitchBorders(HalfEdgeMesh& mesh, const std::vector<bool>& fixed, Progress progress,
                                  double nearWeld) {
  // Relinks what was changed; keeps it when it is better.
  const auto keepIfBetter = [&](HalfEdgeMesh trial, Progress part) {
    HalfEdgeMesh unchanged = mesh;
    const Openness before = measure(unchanged, relink(unchanged, part.part(0.0, 0.5)));
    const Openness after = measure(trial, relink(trial, part.part(0.5, 1.0)));
    if (part.cancelled() || !after.improvesOn(before)) return false;
    mesh = trial;
    return true;
  };
  std::vector<Vertex> moved;
  int trials = 0;
  // All together, then by halves.
  const std::function<void(const Pairs&)> mergeBetter = [&](const Pairs& pairs) {
    if (pairs.empty() || progress.cancelled() || ++trials > kMostTrials) return;
    HalfEdgeMesh trial = mesh;
    const std::vector<Vertex> these = merge(trial, pairs);
    if (keepIfBetter(std::move(trial), progress.part(0.5, 0.5))) {  // nobody knows how many trials it takes
      moved.insert(moved.end(), these.begin(), these.end());
    } else if (pairs.size() > 1) {
      const auto middle = pairs.begin() + static_cast<std::ptrdiff_t>(pairs.size() / 2);
      mergeBetter(Pairs(pairs.begin(), middle));
      mergeBetter(Pairs(middle, pairs.end()));
    }
  };
  const Pairs near = nearBorderVertices(mesh, fixed, nearWeld, progress.part(0.0, 0.15));
  const Pairs closing = closingPairs(mesh, near, progress.part(0.15, 0.2));
  HalfEdgeMesh trial = mesh;
  if (!closing.empty()) moved = merge(trial, near);
  if (!moved.empty() && !keepIfBetter(std::move(trial), progress.part(0.2, 0.5))) {
    moved.clear();
    mergeBetter(closing);
  }
  trial = mesh;
  if (splitTJunctions(trial, fixed, progress.part(0.5, 0.7), nearWeld) > 0)
    keepIfBetter(trial, progress.part(0.7, 1.0));
  return moved;
}

}  // namespace handwheel
