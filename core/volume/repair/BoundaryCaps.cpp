// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/BoundaryCaps.h"

#include "mesh/structure/DisjointSets.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <unordered_map>
#include <vector>

namespace handwheel {
namespace {

constexpr double kFlat = 0.25;  // from the plane of a flat hole, edges of the grid

// An edge between the lower and the higher vertex, how much more often it is passed upwards than downwards, and how
// often in all.
struct Passed {
  std::uint32_t low, high;
  int times;
  int faces;

  bool operator<(const Passed& other) const { return std::pair(low, high) < std::pair(other.low, other.high); }
  bool isSameEdge(const Passed& other) const { return low == other.low && high == other.high; }
  // Passed upwards too often: the cone passes it downwards.
  std::uint32_t from() const { return times > 0 ? high : low; }
  std::uint32_t to() const { return times > 0 ? low : high; }
};

// Returns the edges that do not occur equally often in both directions.
std::vector<Passed> openEdges(const std::vector<Triangle>& triangles) {
  std::vector<Passed> all;
  all.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (a != b) all.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1, 1});
    }
  std::sort(all.begin(), all.end());
  std::vector<Passed> open;
  for (std::size_t i = 0; i < all.size();) {
    Passed sum{all[i].low, all[i].high, 0, 0};
    for (; i < all.size() && all[i].isSameEdge(sum); ++i) {
      sum.times += all[i].times;
      ++sum.faces;
    }
    if (sum.times != 0) open.push_back(sum);
  }
  return open;
}

// The data of a boundary.
struct Boundary {
  std::vector<Passed> edges;
  Vec3 sum = Vec3::Zero();
  double length = 0.0, ofHoles = 0.0;  // all of it; of edges with one face
  Box box;

  void add(const Passed& edge, const std::vector<Vec3>& points) {
    const Vec3 &a = points[edge.low], &b = points[edge.high];
    const double own = (b - a).norm();
    edges.push_back(edge);
    sum += own * 0.5 * (a + b);
    length += own;
    if (edge.faces == 1) ofHoles += own;
    box.extend(a);
    box.extend(b);
  }
  Vec3 middle(const std::vector<Vec3>& points) const {
    return length > 0.0 ? Vec3(sum / length) : points[edges.front().low];
  }
  // Returns true if a cone from the centre is a flat lid.
  bool isFlat(const std::vector<Vec3>& points) const {
    const Vec3 tip = middle(points);
    const auto area = [&](const Passed& edge) {
      return Vec3((points[edge.from()] - tip).cross(points[edge.to()] - tip));
    };
    Vec3 normal = Vec3::Zero();
    for (const Passed& edge : edges) normal += area(edge);
    normal.normalize();
    return std::all_of(edges.begin(), edges.end(), [&](const Passed& edge) {
      return area(edge).dot(normal) >= 0.0 && std::abs(normal.dot(points[edge.low] - tip)) <= kFlat;
    });
  }
};

// Divides a boundary at the vertices that it passes more than once. Each of the loops passes a vertex once; its edges
// are in order, and passed once. A hole that touches another in a vertex so gets a cone of its own.
std::vector<Boundary> simpleLoops(const Boundary& boundary, const std::vector<Vec3>& points) {
  std::vector<Passed> single;
  std::unordered_map<std::uint32_t, std::vector<std::size_t>> leaving;
  for (const Passed& edge : boundary.edges)
    for (int n = 0; n < std::abs(edge.times); ++n) {
      leaving[edge.from()].push_back(single.size());
      single.push_back({edge.low, edge.high, edge.times > 0 ? 1 : -1, edge.faces});
    }
  std::vector<Boundary> loops;
  for (std::size_t first = 0; first < single.size(); ++first) {
    std::vector<std::size_t> path;
    std::unordered_map<std::uint32_t, std::size_t> stepAt;  // by the vertex where the step of the path begins
    std::uint32_t at = single[first].from();
    while (true) {
      if (const auto seen = stepAt.find(at); seen != stepAt.end()) {
        Boundary& loop = loops.emplace_back();
        const std::size_t begin = seen->second;
        for (std::size_t i = begin; i < path.size(); ++i) {
          loop.add(single[path[i]], points);
          stepAt.erase(single[path[i]].from());
        }
        path.resize(begin);
      }
      std::vector<std::size_t>& next = leaving[at];
      if (next.empty()) break;  // every vertex is left as often as it is reached, so the path is empty
      stepAt.emplace(at, path.size());
      path.push_back(next.back());
      at = single[next.back()].to();
      next.pop_back();
    }
  }
  return loops;
}

// Returns a flag for each boundary: true for those of patches whose lids would lie on them, where such patches are most
// of the surface. So a surface that is in pieces all over is closed as a whole, and not each piece with itself.
std::vector<bool> outlinesOfPatches(const std::vector<Boundary>& boundaries, const TriangleSoup& welded) {
  constexpr double kSameArea = 0.9, kMost = 0.5;
  DisjointSets joined(welded.points.size());
  for (const Triangle& t : welded.triangles) {
    joined.join(t[0], t[1]);
    joined.join(t[1], t[2]);
  }
  std::unordered_map<std::uint32_t, double> areas;
  double whole = 0.0, patches = 0.0;
  for (const Triangle& t : welded.triangles) {
    const Vec3& a = welded.points[t[0]];
    const double area = 0.5 * (welded.points[t[1]] - a).cross(welded.points[t[2]] - a).norm();
    areas[joined.root(t[0])] += area;
    whole += area;
  }
  std::vector<bool> isPatch(boundaries.size(), false);
  if (areas.size() < 2) return isPatch;
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    const Vec3 tip = boundaries[i].middle(welded.points);
    double lid = 0.0;
    for (const Passed& edge : boundaries[i].edges)
      lid += 0.5 * (welded.points[edge.low] - tip).cross(welded.points[edge.high] - tip).norm();
    const double own = areas[joined.root(boundaries[i].edges.front().low)];
    isPatch[i] = lid > kSameArea * own;
    if (isPatch[i]) patches += own;
  }
  if (patches < kMost * whole) isPatch.assign(boundaries.size(), false);
  return isPatch;
}

}  // namespace

BoundaryCaps closeBoundaries(TriangleSoup& welded, double wideFrom, Progress progress) {
  BoundaryCaps caps;
  const std::vector<Passed> open = openEdges(welded.triangles);
  if (open.empty() || progress.cancelled()) return caps;
  DisjointSets joined(welded.points.size());
  for (const Passed& edge : open) joined.join(edge.low, edge.high);
  std::unordered_map<std::uint32_t, std::size_t> numbers;
  std::vector<Boundary> boundaries;
  for (const Passed& edge : open) {
    const auto [at, isNew] = numbers.emplace(joined.root(edge.low), boundaries.size());
    if (isNew) boundaries.emplace_back();
    boundaries[at->second].add(edge, welded.points);
  }
  const std::vector<bool> isPatch = outlinesOfPatches(boundaries, welded);
  for (std::size_t i = 0; i < boundaries.size(); ++i)
    for (const Boundary& loop : simpleLoops(boundaries[i], welded.points)) {
      const bool isWide = loop.ofHoles > 0.5 * loop.length &&
                          (isPatch[i] || (loop.box.sizes().maxCoeff() > wideFrom && !loop.isFlat(welded.points)));
      // A point of its own would be beside the plane by its rounding, which rows in that plane would see.
      if (!isWide && loop.edges.size() == 3) {
        welded.triangles.push_back({loop.edges[0].from(), loop.edges[1].from(), loop.edges[2].from()});
        continue;
      }
      const auto tip = static_cast<std::uint32_t>(welded.points.size());
      welded.points.push_back(loop.middle(welded.points) +
                              (isWide ? Vec3(0.1371, 0.2197, 0.1733) : Vec3(Vec3::Zero())));
      for (const Passed& edge : loop.edges) {
        if (isWide) caps.wide.push_back(static_cast<std::uint32_t>(welded.triangles.size()));
        welded.triangles.push_back({edge.from(), edge.to(), tip});
      }
    }
  caps.boundaries = boundaries.size();
  return caps;
}

}  // namespace handwheel
