// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/IslandBridges.h"

#include "mesh/boundary/Bridging.h"
#include "mesh/selection/RegionGrowing.h"
#include "mesh/structure/Orientation.h"
#include "mesh/structure/Shells.h"

#include <algorithm>
#include <limits>

namespace handwheel {
namespace {

constexpr std::size_t kMostBridgesTried = 24;

// The area that a loop encloses, as a vector along its normal (Newell).
Vec3 areaVector(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) {
  const std::vector<Vec3> points = loopPoints(mesh, loop);
  Vec3 doubled = Vec3::Zero();
  for (std::size_t i = 0; i < points.size(); ++i)
    doubled += (points[i] - loop.centre).cross(points[(i + 1) % points.size()] - loop.centre);
  return 0.5 * doubled;
}

struct RankedPair {
  double distance = std::numeric_limits<double>::infinity();
  BoundaryPair ends;
};

// Returns for each border point of the island the nearest one of the hole, nearest pairs first.
std::vector<RankedPair> nearestPairs(const HalfEdgeMesh& mesh, const BoundaryLoop& hole, const BoundaryLoop& island) {
  std::vector<RankedPair> pairs;
  for (const HalfEdge b : island.halfEdges) {
    if (!mesh.isBorder(b)) continue;
    RankedPair best;
    for (const HalfEdge a : hole.halfEdges) {
      const double d = (mesh.position(mesh.from(a)) - mesh.position(mesh.from(b))).norm();
      if (mesh.isBorder(a) && d < best.distance) best = {d, {a, b}};
    }
    if (best.ends.a != kNone) pairs.push_back(best);
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const RankedPair& p, const RankedPair& q) { return p.distance < q.distance; });
  return pairs;
}

}  // namespace

bool bridgeIsland(HalfEdgeMesh& mesh, const BoundaryLoop& hole, const BoundaryLoop& island) {
  HalfEdgeMesh trial = mesh;
  BoundaryLoop inner = island;
  // The boundaries of a hole and of its island run in opposite directions.
  if (areaVector(mesh, hole).dot(areaVector(mesh, island)) > 0.0) {
    const Face seed = HalfEdgeMesh::face(island.halfEdges.front());
    const auto piece = connectedFaces(trial, {&seed, 1}, {});
    if (!piece) return false;
    reverseShells(trial, piece->faces());
    for (HalfEdge& h : inner.halfEdges) h = reversedHalfEdge(h);
    std::reverse(inner.halfEdges.begin(), inner.halfEdges.end());
  }
  std::size_t tries = 0;
  for (const RankedPair& pair : nearestPairs(trial, hole, inner)) {
    if (++tries > kMostBridgesTried) break;
    const FaceLocator near(trial, reachOf(trial, pair.ends));
    const Bridge bridge = findBridge(near, pair.ends);
    if (bridge.problem != JoinProblem::None || addFaces(trial, bridge.triangles, near) != JoinProblem::None) continue;
    mesh = std::move(trial);
    return true;
  }
  return false;
}

}  // namespace handwheel
