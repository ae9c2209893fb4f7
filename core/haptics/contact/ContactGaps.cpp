// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/ContactGaps.h"

#include "base/Tolerance.h"
#include "proximity/ClosestPoint.h"
#include "proximity/TriangleHierarchy.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <unordered_map>

namespace handwheel {
namespace {

struct Edge {
  std::uint32_t from, to;  // in the direction of its triangle
};

// Returns the edges that only one triangle has. of(corner) is the number of a corner.
template <class Numbers>
std::vector<Edge> openEdges(const std::vector<Edge>& edges, const Numbers& of) {
  using Keyed = std::pair<std::pair<std::uint32_t, std::uint32_t>, Edge>;
  std::vector<Keyed> sorted;
  sorted.reserve(edges.size());
  for (const Edge& e : edges) sorted.push_back({{std::min(of(e.from), of(e.to)), std::max(of(e.from), of(e.to))}, e});
  std::sort(sorted.begin(), sorted.end(), [](const Keyed& a, const Keyed& b) { return a.first < b.first; });
  std::vector<Edge> open;
  for (std::size_t i = 0; i < sorted.size();) {
    std::size_t end = i + 1;
    while (end < sorted.size() && sorted[end].first == sorted[i].first) ++end;
    if (end == i + 1 && sorted[i].first.first != sorted[i].first.second) open.push_back(sorted[i].second);
    i = end;
  }
  return open;
}

std::vector<Edge> edgesOf(const std::vector<Triangle>& triangles) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.push_back({t[k], t[(k + 1) % 3]});
  return edges;
}

// Merges corners of open edges: a map from those that are removed to those that stay.
class CornerMerging {
 public:
  CornerMerging(const std::vector<Vec3>& points, const std::vector<Edge>& open, double tolerance)
      : m_points(points), m_cell(tolerance) {
    std::unordered_map<std::uint32_t, double> reach;
    for (const Edge& e : open) {
      const double own = std::min(tolerance, tolerance::kContactGapEdge * (points[e.from] - points[e.to]).norm());
      for (const std::uint32_t v : {e.from, e.to}) {
        const auto [entry, fresh] = reach.try_emplace(v, own);
        if (!fresh) entry->second = std::min(entry->second, own);
      }
    }
    std::vector<std::uint32_t> order;  // the same in each run
    order.reserve(reach.size());
    for (const auto& [v, own] : reach) order.push_back(v);
    std::sort(order.begin(), order.end());
    for (const std::uint32_t v : order) place(v, reach[v]);
  }

  std::uint32_t operator()(std::uint32_t v) const {
    const auto found = m_stands.find(v);
    return found == m_stands.end() ? v : found->second;
  }
  // Moves all merged corners to their middle.
  void move(std::vector<Vec3>& points) const {
    std::unordered_map<std::uint32_t, std::pair<Vec3, int>> shifts;
    for (const auto& [goes, stays] : m_stands) {
      auto& [sum, count] = shifts.try_emplace(stays, Vec3::Zero(), 1).first->second;
      sum += m_points[goes] - m_points[stays];
      ++count;
    }
    for (const auto& [stays, shift] : shifts) points[stays] += shift.first / shift.second;
    for (const auto& [goes, stays] : m_stands) points[goes] = points[stays];
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Cell& c) const {
      std::uint64_t h = 0;
      for (const std::int64_t k : c) h = (h ^ static_cast<std::uint64_t>(k)) * 0x9e3779b97f4a7c15u;
      return static_cast<std::size_t>(h ^ (h >> 32));
    }
  };

  Cell cellOf(const Vec3& p) const {
    const Vec3 origin = p / m_cell;
    return {static_cast<std::int64_t>(std::floor(origin.x())), static_cast<std::int64_t>(std::floor(origin.y())),
            static_cast<std::int64_t>(std::floor(origin.z()))};
  }

  void place(std::uint32_t v, double reach) {
    const Vec3& p = m_points[v];
    const Cell cell = cellOf(p);
    for (int i = 0; i < 27; ++i) {
      const auto found = m_cells.find({cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1});
      if (found == m_cells.end()) continue;
      for (const std::uint32_t other : found->second)
        if ((m_points[other] - p).norm() <= reach) {
          m_stands[v] = other;
          return;
        }
    }
    m_cells[cell].push_back(v);
  }

  const std::vector<Vec3>& m_points;
  double m_cell;
  std::unordered_map<Cell, std::vector<std::uint32_t>, Hash> m_cells;
  std::unordered_map<std::uint32_t, std::uint32_t> m_stands;
};

// The point at which another open edge comes within a gap of a corner.
struct Across {
  std::uint32_t edge = kNone;   // none comes so near
  std::uint32_t point = kNone;  // its nearest point
};

// Strips of triangles across the gaps. Each is attached to an open edge and to the border opposite, along all of its
// corners, so that together they leave no slit: a strip that only comes near the border opposite would dive below it.
class Strips {
 public:
  Strips(std::vector<Vec3>& points, const std::vector<Edge>& open, double gap)
      : m_points(points), m_open(open), m_gap(gap) {
    std::vector<Triangle> segments;
    for (std::uint32_t i = 0; i < open.size(); ++i) {
      segments.push_back({open[i].from, open[i].to, open[i].to});
      only(m_next, open[i].from, i);
      only(m_previous, open[i].to, i);
    }
    m_hierarchy = TriangleHierarchy(points, segments);
    numberAlongBorders();
  }

  void addTo(std::vector<Triangle>& triangles) {
    for (std::size_t i = 0; i < m_open.size(); ++i) {
      const Edge& e = m_open[i];
      const Across from = across(e.from), to = across(e.to);
      if (from.edge == kNone || to.edge == kNone) continue;
      // Between two sheets the tip would be caught: only the first of the borders gets a strip.
      if (m_order[i] > std::min(m_order[from.edge], m_order[to.edge])) continue;
      std::vector<std::uint32_t> border{from.point};
      for (const std::uint32_t corner : between(from.edge, to.edge)) border.push_back(corner);
      border.push_back(to.point);
      triangles.push_back({e.to, e.from, border.front()});
      for (std::size_t k = 0; k + 1 < border.size(); ++k) triangles.push_back({e.to, border[k], border[k + 1]});
    }
  }

 private:
  // Adds an edge at a corner; a corner where borders touch leads to no edge.
  static void only(std::unordered_map<std::uint32_t, std::uint32_t>& edges, std::uint32_t corner, std::uint32_t edge) {
    const auto [entry, fresh] = edges.try_emplace(corner, edge);
    if (!fresh) entry->second = kNone;
  }

  void numberAlongBorders() {
    m_order.assign(m_open.size(), kNone);
    std::uint32_t number = 0;
    for (std::uint32_t first = 0; first < m_open.size(); ++first)
      for (std::uint32_t i = first; i != kNone && m_order[i] == kNone;) {
        m_order[i] = number++;
        const auto found = m_next.find(m_open[i].to);
        i = found == m_next.end() ? kNone : found->second;
      }
  }

  Across across(std::uint32_t v) {
    const auto [entry, isFresh] = m_across.try_emplace(v);
    Across& known = entry->second;
    if (!isFresh) return known;
    const Vec3 p = m_points[v], reach = Vec3::Constant(m_gap);
    Vec3 nearest = p;
    double least = m_gap;
    m_hierarchy.forEachInBox(Box(p - reach, p + reach), [&](std::uint32_t i) {
      const Edge& e = m_open[i];
      if (e.from == v || e.to == v) return true;
      const Vec3 q = closestOnSegment(p, m_points[e.from], m_points[e.to]);
      if (const double d = (q - p).norm(); d < least) {
        least = d;
        nearest = q;
        known.edge = i;
      }
      return true;
    });
    if (known.edge == kNone) return {};
    known.point = static_cast<std::uint32_t>(m_points.size());
    m_points.push_back(nearest);
    return known;
  }

  // Returns the corners that the border passes from one open edge to another, in the shorter direction; none if they
  // are not connected nearby.
  std::vector<std::uint32_t> between(std::uint32_t from, std::uint32_t to) const {
    std::vector<std::uint32_t> ahead, back;
    std::uint32_t forward = from, backward = from;
    for (int i = 0; i < kMostCorners; ++i) {
      if (forward == to) return ahead;
      if (backward == to) return back;
      step(m_next, forward, forward == kNone ? kNone : m_open[forward].to, ahead);
      step(m_previous, backward, backward == kNone ? kNone : m_open[backward].from, back);
    }
    return {};
  }

  static void step(const std::unordered_map<std::uint32_t, std::uint32_t>& edges, std::uint32_t& edge,
                   std::uint32_t corner, std::vector<std::uint32_t>& passed) {
    const auto found = edges.find(corner);
    edge = found == edges.end() ? kNone : found->second;
    passed.push_back(corner);
  }

  // Not a fidelity setting, but a bound: so the time stays in proportion to the open edges, even if a border does not
  // connect two edges. A gap stays open along an edge that has more corners than these on its other side.
  static constexpr int kMostCorners = 64;

  std::vector<Vec3>& m_points;
  const std::vector<Edge>& m_open;
  double m_gap;
  TriangleHierarchy m_hierarchy;
  std::unordered_map<std::uint32_t, std::uint32_t> m_next, m_previous;  // the open edge that leaves, ends at a corner
  std::unordered_map<std::uint32_t, Across> m_across;
  std::vector<std::uint32_t> m_order;  // index of each open edge along the borders
};

}  // namespace

void closeContactGaps(std::vector<Vec3>& points, std::vector<Triangle>& triangles, Progress progress) {
  Box bounds;
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t)
      if (points[v].allFinite()) bounds.extend(points[v]);
  if (bounds.isEmpty() || !(bounds.diagonal().norm() > 0.0)) return;
  const double diagonal = bounds.diagonal().norm();
  std::vector<Edge> open = openEdges(edgesOf(triangles), std::identity{});
  std::erase_if(open, [&](const Edge& e) { return !points[e.from].allFinite() || !points[e.to].allFinite(); });
  if (open.empty() || progress.cancelled()) return;

  // Relative to the middle of the model, so that far from the origin the cells can be distinguished.
  std::vector<Vec3> local(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) local[i] = points[i] - bounds.center();
  const CornerMerging merged(local, open, tolerance::kContactGap * diagonal);
  merged.move(points);
  open = openEdges(open, merged);
  if (progress.cancelled()) return;
  Strips(points, open, tolerance::kContactGap * diagonal).addTo(triangles);
}

}  // namespace handwheel
