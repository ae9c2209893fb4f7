// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/OutlineJoining.h"

#include "base/NumberText.h"
#include "machining/target/TargetErrors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace handwheel {

namespace {

using Segments = std::vector<ProfileSegment>;

constexpr std::size_t kNobody = static_cast<std::size_t>(-1);

// Numbers for points: ends that are nearer than the gap get the same.
class PointIndex {
 public:
  explicit PointIndex(double gap) : m_gap(gap) {}

  std::size_t of(const ProfilePoint& p) {
    const Cell cell = cellOf(p);
    for (std::int64_t i = -1; i <= 1; ++i) {
      for (std::int64_t k = -1; k <= 1; ++k) {
        const auto found = m_cells.find({cell[0] + i, cell[1] + k});
        if (found == m_cells.end()) continue;
        for (const std::size_t index : found->second)
          if ((m_points[index] - p).norm() <= m_gap) return index;
      }
    }
    m_points.push_back(p);
    m_cells[cell].push_back(m_points.size() - 1);
    return m_points.size() - 1;
  }
  const ProfilePoint& point(std::size_t index) const { return m_points[index]; }
  std::size_t size() const { return m_points.size(); }

 private:
  using Cell = std::array<std::int64_t, 2>;
  Cell cellOf(const ProfilePoint& p) const {
    const auto index = [&](double v) {
      return static_cast<std::int64_t>(std::floor(std::clamp(v / m_gap, -1e15, 1e15)));
    };
    return {index(p.x()), index(p.y())};
  }

  double m_gap;
  std::vector<ProfilePoint> m_points;
  std::map<Cell, std::vector<std::size_t>> m_cells;
};

// A segment between two points.
struct Edge {
  ProfileSegment segment;
  std::array<std::size_t, 2> ends;
  bool isUsed = false;
};

Error crossingAt(const ProfilePoint& p) {
  return {TargetError::CrossesItself, {shownText(p.x()), shownText(p.y())}, {}, {}};
}

// Returns the segments as edges, without duplicates. Error: CrossesItself, if more than two connect the same points.
Result<std::vector<Edge>> edgesOf(const Segments& segments, PointIndex& points, double gap, Progress progress) {
  constexpr std::size_t kPerPoll = 1024;
  std::size_t count = 0;
  std::vector<Edge> edges;
  std::map<std::array<std::size_t, 2>, std::vector<std::size_t>> known;
  for (const ProfileSegment& s : segments) {
    if (count++ % kPerPoll == 0 && progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    if (!(s.length() > gap)) continue;
    Edge edge{s, {points.of(s.from), points.of(s.to)}, false};
    if (edge.ends[0] == edge.ends[1]) continue;
    edge.segment.from = points.point(edge.ends[0]);
    edge.segment.to = points.point(edge.ends[1]);
    auto& between = known[{std::min(edge.ends[0], edge.ends[1]), std::max(edge.ends[0], edge.ends[1])}];
    const ProfilePoint middle = s.at(0.5);
    const bool isTwice = std::any_of(between.begin(), between.end(), [&](std::size_t k) {
      return (edges[k].segment.at(0.5) - middle).norm() <= 2.0 * gap;
    });
    if (isTwice) continue;
    if (between.size() == 2) return crossingAt(edge.segment.from);  // so each is compared with two at most
    between.push_back(edges.size());
    edges.push_back(edge);
  }
  return edges;
}

// The edges that end at each point, at most two.
using EdgesAt = std::vector<std::array<std::size_t, 2>>;

Result<EdgesAt> edgesAt(const std::vector<Edge>& edges, const PointIndex& points) {
  EdgesAt at(points.size(), {kNobody, kNobody});
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (const std::size_t end : edges[i].ends) {
      auto& there = at[end];
      if (there[1] != kNobody) return crossingAt(points.point(end));
      there[there[0] == kNobody ? 0 : 1] = i;
    }
  }
  return at;
}

// Returns the chain from a point along all edges that follow.
Segments walk(std::size_t index, std::vector<Edge>& edges, const EdgesAt& at) {
  Segments chain;
  while (true) {
    std::size_t next = kNobody;
    for (const std::size_t edge : at[index])
      if (edge != kNobody && !edges[edge].isUsed) next = edge;
    if (next == kNobody) return chain;
    Edge& edge = edges[next];
    edge.isUsed = true;
    const bool isForward = edge.ends[0] == index;
    chain.push_back(isForward ? edge.segment : edge.segment.reversed());
    index = edge.ends[isForward ? 1 : 0];
  }
}

// Returns open chains from an end, then rings from any point.
std::vector<Segments> chainsOf(std::vector<Edge>& edges, const EdgesAt& at) {
  std::vector<Segments> chains;
  for (std::size_t index = 0; index < at.size(); ++index) {
    if (at[index][1] != kNobody || at[index][0] == kNobody || edges[at[index][0]].isUsed) continue;
    chains.push_back(walk(index, edges, at));
  }
  for (const Edge& edge : edges)
    if (!edge.isUsed) chains.push_back(walk(edge.ends[0], edges, at));
  return chains;
}

Segments reversedChain(Segments chain) {
  std::reverse(chain.begin(), chain.end());
  for (ProfileSegment& s : chain) s = s.reversed();
  return chain;
}

// Joins outside and bore, if their ends are beside one another.
bool joinByFaces(std::vector<Segments>& chains, double gap) {
  if (chains.size() != 2) return false;
  Segments& first = chains[0];
  Segments second = chains[1];
  const auto isLevel = [&](const ProfilePoint& a, const ProfilePoint& b) { return std::abs(a.y() - b.y()) <= gap; };
  for (const Segments* chain : {&first, &second})
    if (chain->front().from == chain->back().to) return false;
  if (!isLevel(first.back().to, second.front().from)) second = reversedChain(std::move(second));
  if (!isLevel(first.back().to, second.front().from) || !isLevel(second.back().to, first.front().from)) return false;
  const ProfilePoint start = first.front().from;
  first.push_back({first.back().to, second.front().from, 0.0});
  first.insert(first.end(), second.begin(), second.end());
  first.push_back({first.back().to, start, 0.0});
  chains.pop_back();
  return true;
}

}  // namespace

Result<std::vector<ProfileSegment>> joinedOutline(const std::vector<ProfileSegment>& segments, double gap,
                                                  Progress progress) {
  PointIndex points(gap);
  Result<std::vector<Edge>> joined = edgesOf(segments, points, gap, progress);
  if (!joined) return joined.error();
  std::vector<Edge>& edges = joined.value();
  if (edges.empty()) return Error{TargetError::NoProfile, {}, {}, {}};
  const Result<EdgesAt> at = edgesAt(edges, points);
  if (!at) return at.error();
  std::vector<Segments> chains = chainsOf(edges, *at);
  if (chains.size() > 1 && !joinByFaces(chains, gap))
    return Error{TargetError::SeveralProfiles, {std::to_string(chains.size())}, {}, {}};
  return chains.front();
}

}  // namespace handwheel
