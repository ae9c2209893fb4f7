// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/OrientationReversal.h"

#include "mesh/structure/Orientation.h"

#include <algorithm>
#include <queue>

namespace handwheel {
namespace {

using Run = std::span<const EdgeTable::Entry>;

// Returns true if two triangles on an edge disagree after the reversals.
bool disagree(std::span<const Triangle> triangles, const std::vector<bool>& turn, std::uint32_t g, std::uint32_t h) {
  const bool isSameDirection = triangles[g / 3][g % 3] == triangles[h / 3][h % 3];
  return isSameDirection == (turn[g / 3] == turn[h / 3]);
}

// A graph of the surface: each fan of connected triangles around a point is a node; each edge with one or two triangles
// connects the fans at its ends. An edge is odd if left becomes right along it.
class FanGraph {
 public:
  FanGraph(const EdgeTable& edges, std::span<const Triangle> triangles, std::span<const Vec3> points, Progress progress)
      : m_triangles(triangles), m_root(3 * triangles.size()), m_isOdd(3 * triangles.size(), false) {
    const std::vector<bool> turn = trianglesToReverse(edges, triangles, progress.part(0.0, 0.6));
    for (std::uint32_t c = 0; c < m_root.size(); ++c) m_root[c] = c;
    const auto forEachInner = [&](auto visit) {
      edges.forEachEdge([&](std::uint32_t, std::uint32_t, Run run) {
        if (run.size() == 2) visit(run[0].halfEdge, run[1].halfEdge);
      });
    };
    forEachInner([&](std::uint32_t g, std::uint32_t h) {
      const bool isOdd = disagree(triangles, turn, g, h), isSameDirection = from(g) == from(h);
      const std::uint32_t a = h, b = h - h % 3 + (h % 3 + 1) % 3;
      join(g, isSameDirection ? a : b, isOdd);
      join(g - g % 3 + (g % 3 + 1) % 3, isSameDirection ? b : a, isOdd);
    });
    if (progress.cancelled()) return;
    collect(edges, points);
  }

  struct Step {
    std::uint32_t to;  // fan
    bool isOdd;
    bool isBorder;
    double length;
    std::uint32_t halfEdge;
  };
  std::span<const Step> steps(std::uint32_t fan) const {
    return std::span(m_steps).subspan(m_starts[fan], m_starts[fan + 1] - m_starts[fan]);
  }
  // Returns fans such that each odd edge has one of its ends among them.
  const std::vector<std::uint32_t>& sources() const { return m_sources; }
  std::size_t size() const { return m_root.size(); }

 private:
  std::uint32_t from(std::uint32_t h) const { return m_triangles[h / 3][h % 3]; }

  std::uint32_t find(std::uint32_t c, bool& isOdd) const {
    while (m_root[c] != c) {
      isOdd = isOdd != m_isOdd[c];
      c = m_root[c];
    }
    return c;
  }

  void join(std::uint32_t a, std::uint32_t b, bool isOdd) {
    bool oddA = false, oddB = false;
    const std::uint32_t rootA = find(a, oddA), rootB = find(b, oddB);
    if (rootA == rootB) return;
    m_root[rootA] = rootB;
    m_isOdd[rootA] = isOdd != (oddA != oddB);
  }

  void collect(const EdgeTable& edges, std::span<const Vec3> points) {
    std::vector<std::pair<std::uint32_t, Step>> all;
    edges.forEachEdge([&](std::uint32_t low, std::uint32_t high, Run run) {
      if (run.size() > 2) return;
      bool isOdd = false;
      const bool isBorder = run.size() == 1;
      const std::uint32_t g = run[0].halfEdge;
      const std::uint32_t a = find(g, isOdd), b = find(g - g % 3 + (g % 3 + 1) % 3, isOdd);
      const double length = isBorder ? 0.0 : (points[low] - points[high]).stableNorm();
      all.push_back({a, {b, isOdd, isBorder, length, g}});
      all.push_back({b, {a, isOdd, isBorder, length, g}});
      if (isOdd) m_sources.push_back(a);
    });
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    m_starts.assign(m_root.size() + 1, all.size());
    for (std::size_t i = all.size(); i-- > 0;) m_starts[all[i].first] = i;
    for (std::size_t fan = m_root.size(); fan-- > 0;) m_starts[fan] = std::min(m_starts[fan], m_starts[fan + 1]);
    for (const auto& [fan, step] : all) m_steps.push_back(step);
    std::sort(m_sources.begin(), m_sources.end());
    m_sources.erase(std::unique(m_sources.begin(), m_sources.end()), m_sources.end());
  }

  std::span<const Triangle> m_triangles;
  std::vector<std::uint32_t> m_root;  // by corner
  std::vector<bool> m_isOdd;          // against the root
  std::vector<std::size_t> m_starts;
  std::vector<Step> m_steps;
  std::vector<std::uint32_t> m_sources;
};

// Search for paths from a fan to its mirror image. Nodes are 2 · fan + side.
class MirrorSearch {
 public:
  explicit MirrorSearch(const FanGraph& graph)
      : m_graph(graph), m_distance(2 * graph.size(), kFar), m_by(2 * graph.size()) {}

  // Returns the shortest path below the limit.
  std::optional<OrientationReversingCycle> from(std::uint32_t fan, double limit, Progress progress) {
    for (const std::uint32_t node : m_reached) m_distance[node] = kFar;
    m_reached.clear();
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    reach(2 * fan, 0.0, open);
    for (std::size_t n = 0; !open.empty() && pollProgress(n, ~std::size_t{0}, progress); ++n) {
      const auto [distance, node] = open.top();
      open.pop();
      if (distance > m_distance[node]) continue;
      if (node == 2 * fan + 1) return cycleOf(fan, distance);
      for (const FanGraph::Step& step : m_graph.steps(node / 2)) {
        const std::uint32_t to = 2 * step.to + ((node % 2 == 1) != step.isOdd);
        const double length = distance + step.length;
        if (!(length < limit) || !(length < m_distance[to])) continue;
        reach(to, length, open);
        m_by[to] = {node, step.halfEdge, step.isBorder};
      }
    }
    return std::nullopt;
  }

 private:
  using Entry = std::pair<double, std::uint32_t>;
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  struct By {
    std::uint32_t node = 0;
    std::uint32_t halfEdge = 0;
    bool isBorder = false;
  };

  template <class Queue>
  void reach(std::uint32_t node, double distance, Queue& open) {
    if (m_distance[node] == kFar) m_reached.push_back(node);
    m_distance[node] = distance;
    open.push({distance, node});
  }

  OrientationReversingCycle cycleOf(std::uint32_t fan, double length) const {
    OrientationReversingCycle loop{length, {}};
    for (std::uint32_t node = 2 * fan + 1; node != 2 * fan; node = m_by[node].node) {
      if (m_by[node].isBorder) loop.isOnBorder = true;
      if (!m_by[node].isBorder) loop.halfEdges.push_back(m_by[node].halfEdge);
    }
    std::reverse(loop.halfEdges.begin(), loop.halfEdges.end());
    return loop;
  }

  const FanGraph& m_graph;
  std::vector<double> m_distance;
  std::vector<By> m_by;
  std::vector<std::uint32_t> m_reached;
};

}  // namespace

OrientationFaults findOrientationFaults(const EdgeTable& edges, std::span<const Triangle> triangles,
                                        Progress progress) {
  OrientationFaults faults;
  auto& found = faults.nonOrientableEdges;
  const auto collect = [&](const std::vector<bool>& turn, Progress now) {
    edges.forEachEdge(
        [&](std::uint32_t low, std::uint32_t high, Run run) {
          if (run.size() == 2 && disagree(triangles, turn, run[0].halfEdge, run[1].halfEdge))
            found.emplace_back(low, high);
        },
        now);
  };
  collect(std::vector<bool>(triangles.size(), false), progress.part(0.0, 0.3));
  if (found.empty()) return faults;  // the usual case: neighbours already agree
  found.clear();
  const std::vector<bool> turn = trianglesToReverse(edges, triangles, progress.part(0.3, 0.8));
  for (std::uint32_t t = 0; t < turn.size(); ++t)
    if (turn[t]) faults.trianglesToReverse.push_back(t);
  collect(turn, progress.part(0.8, 1.0));
  return faults;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> nonOrientableEdges(const EdgeTable& edges,
                                                                        std::span<const Triangle> triangles,
                                                                        Progress progress) {
  return findOrientationFaults(edges, triangles, progress).nonOrientableEdges;
}

std::optional<OrientationReversingCycle> shortestOrientationReversingCycle(const EdgeTable& edges,
                                                                           std::span<const Triangle> triangles,
                                                                           std::span<const Vec3> points, double longest,
                                                                           Progress progress) {
  const FanGraph graph(edges, triangles, points, progress.part(0.0, 0.3));
  if (progress.cancelled() || graph.sources().empty()) return std::nullopt;
  MirrorSearch search(graph);
  std::optional<OrientationReversingCycle> best;
  double limit = std::nextafter(longest, std::numeric_limits<double>::infinity());
  for (const std::uint32_t fan : graph.sources()) {
    auto found = search.from(fan, limit, progress.part(0.3, 1.0));
    if (progress.cancelled()) return std::nullopt;
    if (!found) continue;
    limit = found->length;
    best = std::move(found);
  }
  return best;
}

}  // namespace handwheel
