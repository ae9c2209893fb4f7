// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/EdgePairing.h"

#include "mesh/structure/HalfEdgeMesh.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

// A half-edge around its edge, seen against the direction low → high.
struct Spoke {
  std::uint32_t halfEdge;
  bool forward;  // runs low → high: the solid is clockwise of it
  double angle;
};

std::vector<Spoke> spokesByAngle(std::span<const EdgeTable::Entry> run, std::uint32_t low, std::uint32_t high,
                                 std::span<const Triangle> triangles, std::span<const Vec3> points) {
  const Vec3& origin = points[low];
  const Vec3 axis = (points[high] - origin).stableNormalized();
  Eigen::Index smallest = 0;
  axis.cwiseAbs().minCoeff(&smallest);
  const Vec3 x = axis.cross(Vec3::Unit(smallest)).stableNormalized();
  const Vec3 y = axis.cross(x);

  std::vector<Spoke> spokes;
  for (const EdgeTable::Entry& e : run) {
    const Triangle& t = triangles[e.halfEdge / 3];
    const Vec3 d = points[t[(e.halfEdge + 2) % 3]] - origin;
    spokes.push_back({e.halfEdge, t[e.halfEdge % 3] == low, std::atan2(d.dot(y), d.dot(x))});
  }
  // At the same angle, the spoke that ends a wedge comes before the one that begins the next.
  std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) {
    if (a.angle != b.angle) return a.angle < b.angle;
    return a.forward != b.forward ? a.forward : a.halfEdge < b.halfEdge;
  });
  return spokes;
}

// Matches each backward spoke (a wedge begins) with the next free forward one (it ends), like brackets on a circle.
template <class Pair>
std::size_t pairWedges(const std::vector<Spoke>& spokes, Pair pair) {
  std::vector<bool> done(spokes.size(), false);
  std::vector<std::size_t> begun;
  for (int round = 0; round < 2; ++round) {  // the second finds wedges across the starting angle
    for (std::size_t i = 0; i < spokes.size(); ++i) {
      if (done[i]) continue;
      if (!spokes[i].forward) {
        if (round == 0) begun.push_back(i);
      } else if (!begun.empty()) {
        pair(spokes[begun.back()].halfEdge, spokes[i].halfEdge);
        done[i] = done[begun.back()] = true;
        begun.pop_back();
      }
    }
  }
  return static_cast<std::size_t>(std::count(done.begin(), done.end(), false));
}

}  // namespace

PairedEdges pairEdges(const EdgeTable& edges, std::span<const Triangle> triangles, std::span<const Vec3> points,
                      Progress progress) {
  PairedEdges result;
  std::vector<std::uint32_t>& opposite = result.opposite;
  opposite.assign(3 * triangles.size(), static_cast<std::uint32_t>(Open::Border));
  const auto pair = [&](std::uint32_t a, std::uint32_t b) {
    opposite[a] = b;
    opposite[b] = a;
  };
  const auto from = [&](std::uint32_t h) { return triangles[h / 3][h % 3]; };

  const auto join = [&](std::uint32_t low, std::uint32_t high, std::span<const EdgeTable::Entry> run) {
    if (run.size() == 1) return;
    if (run.size() == 2 && from(run[0].halfEdge) != from(run[1].halfEdge)) {
      pair(run[0].halfEdge, run[1].halfEdge);
      return;
    }
    for (const EdgeTable::Entry& e : run) opposite[e.halfEdge] = static_cast<std::uint32_t>(Open::Seam);
    result.nonManifoldEdges += run.size() > 2;
    result.seams += pairWedges(spokesByAngle(run, low, high, triangles, points), pair);
  };
  edges.forEachEdge(join, progress);
  return result;
}

}  // namespace handwheel
