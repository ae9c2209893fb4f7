// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/measure/CoveredArea.h"

#include "mesh/structure/CancelPolling.h"

#include <algorithm>

namespace handwheel {

namespace {

using Point = Eigen::Vector2d;

// An edge that is not level, from its lower to its upper end.
struct SweepEdge {
  Point low, high;
  int turn;  // +1 when the curve runs upwards: to its left is the inside of a curve that goes round counter-clockwise

  double xAt(double y) const {
    const double share = std::clamp((y - low.y()) / (high.y() - low.y()), 0.0, 1.0);
    return low.x() + share * (high.x() - low.x());
  }
};

std::vector<SweepEdge> edgesFromBelow(const std::vector<std::vector<Point>>& curves) {
  Eigen::AlignedBox2d box;
  for (const auto& curve : curves) {
    for (const Point& p : curve) box.extend(p);
  }
  if (box.isEmpty()) return {};
  const Point origin = box.center();  // keeps the precision of curves far away
  std::vector<SweepEdge> edges;
  for (const auto& curve : curves) {
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Point a = curve[i] - origin, b = curve[(i + 1) % curve.size()] - origin;
      if (a.y() < b.y()) edges.push_back({a, b, 1});
      if (b.y() < a.y()) edges.push_back({b, a, -1});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const SweepEdge& a, const SweepEdge& b) { return a.low.y() < b.low.y(); });
  return edges;
}

// The height at which two edges change sides, within both of them.
void addCrossing(const SweepEdge& a, const SweepEdge& b, std::vector<double>& heights) {
  const double from = std::max(a.low.y(), b.low.y()), to = std::min(a.high.y(), b.high.y());
  const double before = a.xAt(from) - b.xAt(from), after = a.xAt(to) - b.xAt(to);
  if ((before < 0.0 && after > 0.0) || (before > 0.0 && after < 0.0)) {
    heights.push_back(from + before / (before - after) * (to - from));
  }
}

class Strips {
 public:
  explicit Strips(const std::vector<SweepEdge>& edges) : m_edges(edges) {}

  // The edges that cross the strip above a height. Queries must have ascending heights.
  const std::vector<const SweepEdge*>& at(double height) {
    std::erase_if(m_active, [height](const SweepEdge* e) { return e->high.y() <= height; });
    for (; m_next < m_edges.size() && m_edges[m_next].low.y() <= height; ++m_next) {
      if (m_edges[m_next].high.y() > height) m_active.push_back(&m_edges[m_next]);
    }
    return m_active;
  }

 private:
  const std::vector<SweepEdge>& m_edges;
  std::size_t m_next = 0;
  std::vector<const SweepEdge*> m_active;
};

std::vector<double> heightsOf(const std::vector<SweepEdge>& edges, const Progress& progress) {
  std::vector<double> heights;
  std::vector<const SweepEdge*> active;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!pollProgress(i, edges.size(), progress, kSearchesPerPoll)) return {};
    const SweepEdge& edge = edges[i];
    heights.push_back(edge.low.y());
    heights.push_back(edge.high.y());
    std::erase_if(active, [&](const SweepEdge* other) { return other->high.y() <= edge.low.y(); });
    for (const SweepEdge* other : active) addCrossing(edge, *other, heights);
    active.push_back(&edge);
  }
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

// Returns the covered length of a horizontal line.
double coveredLength(const std::vector<const SweepEdge*>& active, double height,
                     std::vector<std::pair<double, int>>& row) {
  row.clear();
  for (const SweepEdge* edge : active) row.emplace_back(edge->xAt(height), edge->turn);
  std::sort(row.begin(), row.end());
  double length = 0.0;
  int around = 0;
  for (std::size_t i = 0; i + 1 < row.size(); ++i) {
    around += row[i].second;
    if (around != 0) length += row[i + 1].first - row[i].first;
  }
  return length;
}

}  // namespace

double coveredArea(const std::vector<std::vector<Point>>& curves, Progress progress) {
  const std::vector<SweepEdge> edges = edgesFromBelow(curves);
  const std::vector<double> heights = heightsOf(edges, progress.part(0.0, 0.5));
  const Progress second = progress.part(0.5, 1.0);
  Strips strips(edges);
  std::vector<std::pair<double, int>> row;
  double area = 0.0;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    if (!pollProgress(i, heights.size(), second, kSearchesPerPoll)) return 0.0;
    const double bottom = heights[i], top = heights[i + 1];
    area += (top - bottom) * coveredLength(strips.at(bottom), 0.5 * (bottom + top), row);
  }
  return area;
}

}  // namespace handwheel
