// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/BoundaryCaps.h"

#include "mesh/structure/DisjointSets.h"

#include <algorithm>
#include <cstdlib>
#include <unordered_map>
#include <vector>

namespace handwheel {
namespace {

// An edge between the lower and the higher vertex, and how much more often it is passed upwards than downwards.
struct Passed {
  std::uint32_t low, high;
  int times;

  bool operator<(const Passed& other) const { return std::pair(low, high) < std::pair(other.low, other.high); }
  bool isSameEdge(const Passed& other) const { return low == other.low && high == other.high; }
};

// The edges that are not passed equally often both ways.
std::vector<Passed> openEdges(const std::vector<Triangle>& triangles) {
  std::vector<Passed> all;
  all.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (a != b) all.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
    }
  std::sort(all.begin(), all.end());
  std::vector<Passed> open;
  for (std::size_t i = 0; i < all.size();) {
    Passed sum{all[i].low, all[i].high, 0};
    for (; i < all.size() && all[i].isSameEdge(sum); ++i) sum.times += all[i].times;
    if (sum.times != 0) open.push_back(sum);
  }
  return open;
}

}  // namespace

std::size_t closeBoundaries(TriangleSoup& welded, Progress progress) {
  const std::vector<Passed> open = openEdges(welded.triangles);
  if (open.empty() || progress.cancelled()) return 0;
  DisjointSets joined(welded.points.size());
  for (const Passed& edge : open) joined.join(edge.low, edge.high);

  struct Middle {
    Vec3 sum = Vec3::Zero();
    double weight = 0.0;
    std::uint32_t point = kNone;
  };
  std::unordered_map<std::uint32_t, Middle> middles;
  for (const Passed& edge : open) {
    const Vec3 &a = welded.points[edge.low], &b = welded.points[edge.high];
    const double length = (b - a).norm();
    Middle& middle = middles[joined.root(edge.low)];
    middle.sum += length * 0.5 * (a + b);
    middle.weight += length;
  }
  for (const Passed& edge : open) {
    Middle& middle = middles[joined.root(edge.low)];
    if (middle.point == kNone) {
      middle.point = static_cast<std::uint32_t>(welded.points.size());
      welded.points.push_back(middle.weight > 0.0 ? Vec3(middle.sum / middle.weight) : welded.points[edge.low]);
    }
    // Passed upwards too often: the cones pass it downwards.
    const auto from = edge.times > 0 ? edge.high : edge.low, to = edge.times > 0 ? edge.low : edge.high;
    for (int i = 0; i < std::abs(edge.times); ++i) welded.triangles.push_back({from, to, middle.point});
  }
  return middles.size();
}

}  // namespace handwheel
