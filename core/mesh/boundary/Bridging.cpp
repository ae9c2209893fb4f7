// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/Bridging.h"

#include "mesh/search/MovedFaces.h"
#include "mesh/structure/FaceNormal.h"

#include <algorithm>
#include <limits>

namespace handwheel {
namespace {

// Returns a score between 0 for a bad bridge and 1 for equilateral triangles coplanar with their neighbours. The new
// faces must be the last of the mesh.
double score(const HalfEdgeMesh& mesh, std::size_t count) {
  double worst = std::numeric_limits<double>::infinity(), bend = 1.0;
  const auto first = static_cast<Face>(mesh.faceSlots() - count);
  for (Face f = first; f < mesh.faceSlots(); ++f) {
    worst = std::min(worst, slimness(mesh.points(f)));
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      if (!mesh.hasOpposite(h)) continue;
      const Vec3 other = unitNormal(mesh.points(HalfEdgeMesh::face(mesh.opposite(h))));
      bend = std::min(bend, unitNormal(mesh.points(f)).dot(other));
    }
  }
  return worst * 0.5 * (1.0 + bend);
}

// Returns the possible pairs of triangles along the line between the two points.
std::vector<std::vector<Triangle>> candidatePairs(const HalfEdgeMesh& mesh, const BoundaryPair& ends) {
  const Vertex v = mesh.from(ends.a), w = mesh.from(ends.b);
  const Vertex afterV = mesh.to(ends.a), afterW = mesh.to(ends.b);
  const Vertex beforeV = mesh.from(previousOpen(mesh, ends.a)), beforeW = mesh.from(previousOpen(mesh, ends.b));
  return {
      {{afterV, v, w}, {afterV, w, beforeW}},   // the line is their border
      {{afterW, w, v}, {afterW, v, beforeV}},   //
      {{afterV, v, beforeW}, {v, w, beforeW}},  //
      {{afterW, w, beforeV}, {w, v, beforeV}},  //
      {{afterV, v, w}, {afterW, w, v}},         // the line is between them
      {{v, beforeV, w}, {w, beforeW, v}},       //
  };
}

}  // namespace

HalfEdge previousOpen(const HalfEdgeMesh& mesh, HalfEdge h) {
  return HalfEdgeMesh::previous(mesh.fan(h).back());
}

Box reachOf(const HalfEdgeMesh& mesh, const BoundaryPair& ends) {
  Box box;
  for (const HalfEdge end : {ends.a, ends.b}) {
    for (const HalfEdge h : {end, HalfEdgeMesh::next(end), previousOpen(mesh, end)}) {
      for (const HalfEdge g : mesh.fan(h))
        for (const Vec3& p : mesh.points(HalfEdgeMesh::face(g))) box.extend(p);
    }
  }
  return box;
}

Bridge findBridge(const FaceLocator& near, const BoundaryPair& ends) {
  const HalfEdgeMesh& mesh = near.mesh();
  Bridge best{JoinProblem::SamePoint, {}};
  if (mesh.position(mesh.from(ends.a)) == mesh.position(mesh.from(ends.b))) return best;
  double bestScore = -1.0;
  for (std::vector<Triangle>& pair : candidatePairs(mesh, ends)) {
    std::erase_if(pair, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    if (pair.empty()) continue;
    HalfEdgeMesh trial = mesh;
    const JoinProblem problem = addFaces(trial, pair, near);
    if (problem != JoinProblem::None) {
      if (best.triangles.empty()) best.problem = problem;
      continue;
    }
    const double s = score(trial, pair.size());
    if (s <= bestScore) continue;
    bestScore = s;
    best = {JoinProblem::None, std::move(pair)};
  }
  return best;
}

}  // namespace handwheel
