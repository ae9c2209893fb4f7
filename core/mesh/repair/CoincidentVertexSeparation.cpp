// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/CoincidentVertexSeparation.h"

#include "mesh/defects/NonManifoldEdges.h"
#include "mesh/defects/NonManifoldVertices.h"
#include "mesh/repair/FanSeparator.h"
#include "mesh/structure/PositionTriangles.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <unordered_set>

namespace handwheel {
namespace {

bool isKept(const HalfEdgeMesh& mesh, const std::vector<HalfEdge>& fan, const SeparationLimits& limits) {
  return limits.kept && !mesh.hasOpposite(fan.front()) &&
         limits.kept->contains(positionKey(mesh.position(mesh.from(fan.front()))));
}

// Moves fans off their common position until one is left: new ones first, then small ones.
void partFans(FanSeparator& separator, const HalfEdgeMesh& mesh, Fans& fans, const SeparationLimits& limits,
              std::vector<Vertex>& moved) {
  std::vector<std::tuple<bool, std::size_t, Vertex>> order;
  for (const auto& [v, fan] : fans) order.emplace_back(v < limits.firstNew, fan.size(), v);
  std::sort(order.begin(), order.end());
  for (const auto& [isOld, size, v] : order) {
    if (fans.size() == 1) return;
    if (isKept(mesh, fans[v], limits) || !separator.separate(fans[v])) continue;
    moved.push_back(v);
    fans.erase(v);
  }
}

// The positions to separate; empty: all positions.
using Positions = std::set<PointKey>;

bool isMeant(const HalfEdgeMesh& mesh, HalfEdge h, const Positions& only) {
  const auto isIn = [&](Vertex v) { return only.contains(positionKey(mesh.position(v))); };
  return only.empty() || (isIn(mesh.from(h)) && isIn(mesh.to(h)));
}

// Edges between vertices that have one fan each: the same fan passes twice. An edge whose face was split waits for the
// next pass, because its half-edge may have moved into the new face.
void partEdges(FanSeparator& separator, const HalfEdgeMesh& mesh, const Positions& only, std::vector<Vertex>& added,
               Progress progress) {
  for (bool again = true; again;) {
    again = false;
    std::unordered_set<Face> split;
    for (HalfEdge h : surplusEdges(mesh, progress.part(0.0, 0.0))) {  // the number of passes is unknown
      if (progress.cancelled()) return;
      const Face f = HalfEdgeMesh::face(h), g = HalfEdgeMesh::face(mesh.opposite(h));
      if (split.contains(f) || split.contains(g) || !isMeant(mesh, h, only)) continue;
      const Vertex middle = separator.separateEdge(h);
      if (middle == kNone) continue;
      added.push_back(middle);
      split.insert({f, g});
      again = true;
    }
  }
}

void partAll(FanSeparator& separator, const HalfEdgeMesh& mesh, std::map<std::uint32_t, Fans>& found,
             const Positions& only, const SeparationLimits& limits, std::vector<Vertex>& moved, Progress progress) {
  // A vertex that cannot move at first may do so after its neighbours along the edge have moved.
  for (std::size_t before = 0, pass = 0; pass == 0 || moved.size() > before; ++pass) {
    before = moved.size();
    for (auto& [c, fans] : found) {
      if (progress.cancelled()) return;
      partFans(separator, mesh, fans, limits, moved);
    }
  }
  partEdges(separator, mesh, only, moved, progress);
}

}  // namespace

std::vector<Vertex> separateCoincidentVertices(HalfEdgeMesh& mesh, NumberType numbers, Progress progress,
                                               const std::function<std::size_t()>& spareCrossings,
                                               const std::vector<Vertex>& at, const SeparationLimits& limits) {
  Positions only;
  for (const Vertex v : at) only.insert(positionKey(mesh.position(v)));
  const auto fans = [&](Progress now) { return at.empty() ? nonManifoldFans(mesh, now) : fansAt(mesh, at, now); };
  std::map<std::uint32_t, Fans> found = fans(progress.part(0.0, 0.5));
  if (found.empty() && at.empty()) return {};
  FanSeparator separator(mesh, numbers, progress.part(0.5, 0.8), progress.part(0.8, 0.8));
  std::vector<Vertex> moved;
  partAll(separator, mesh, found, only, limits, moved, progress.part(0.8, 0.9));
  if (!spareCrossings || progress.cancelled()) return moved;
  found = fans(progress.part(0.9, 0.95));
  if (found.empty()) return moved;
  separator.mayCross(spareCrossings());
  partAll(separator, mesh, found, only, limits, moved, progress.part(0.95, 1.0));
  return moved;
}

std::vector<Vertex> separateTouchingVertices(HalfEdgeMesh& mesh, NumberType numbers, Progress progress,
                                             const SeparationLimits& limits) {
  const std::vector<Vertex> touching = findNonManifoldVertices(mesh, progress.part(0.0, 0.2));
  if (touching.empty()) return {};
  return separateCoincidentVertices(mesh, numbers, progress.part(0.2, 1.0), {}, touching, limits);
}

}  // namespace handwheel
