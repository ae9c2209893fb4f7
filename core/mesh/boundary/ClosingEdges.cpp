// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/ClosingEdges.h"

#include "mesh/structure/CancelPolling.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

namespace handwheel {
namespace {

// The target positions of the vertices of pairs. A chain of pairs moves onto its first vertex.
class Goals {
 public:
  Goals(const HalfEdgeMesh& mesh, const VertexPairs& pairs) : m_mesh(mesh) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {  // by rising second vertex: those before are known
      const auto first = m_moves.find(pairs[i].first);
      const Vertex goal = first == m_moves.end() ? pairs[i].first : first->second.goal;
      m_moves.emplace(pairs[i].second, Move{i, goal, pairs[i].first});
    }
  }

  PointKey positionOf(Vertex v) const {
    const auto move = m_moves.find(v);
    return positionKey(m_mesh.position(move == m_moves.end() ? v : move->second.goal));
  }

  // The pairs through which the vertex moves.
  void collect(Vertex v, std::set<std::size_t>& pairs) const {
    for (auto move = m_moves.find(v); move != m_moves.end(); move = m_moves.find(move->second.next))
      if (!pairs.insert(move->second.pair).second) return;
  }

 private:
  struct Move {
    std::size_t pair;
    Vertex goal, next;
  };
  const HalfEdgeMesh& m_mesh;
  std::unordered_map<Vertex, Move> m_moves;
};

using DirectedEdges = std::map<std::pair<PointKey, PointKey>, std::vector<HalfEdge>>;

// An end of edges that become one.
class EdgeEnd {
 public:
  void add(const HalfEdgeMesh& mesh, Vertex v) {
    m_vertices.push_back(v);
    m_positions.insert(positionKey(mesh.position(v)));
  }

  void collect(const Goals& goals, std::set<std::size_t>& pairs, std::vector<PointKey>& positions) const {
    positions.insert(positions.end(), m_positions.begin(), m_positions.end());
    if (m_positions.size() < 2) return;
    for (const Vertex v : m_vertices) goals.collect(v, pairs);
  }

 private:
  std::vector<Vertex> m_vertices;
  std::set<PointKey> m_positions;
};

}  // namespace

std::vector<ClosingEdge> closingEdges(const HalfEdgeMesh& mesh, const VertexPairs& pairs, Progress progress) {
  if (pairs.empty()) return {};
  const Goals goals(mesh, pairs);
  DirectedEdges edges;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    if (!pollProgress(h, mesh.halfEdgeSlots(), progress.part(0.0, 0.7))) return {};
    if (mesh.isBorder(h)) edges[{goals.positionOf(mesh.from(h)), goals.positionOf(mesh.to(h))}].push_back(h);
  }
  std::vector<ClosingEdge> closing;
  std::size_t seen = 0;
  for (const auto& [ends, forward] : edges) {
    if (!pollProgress(seen++, edges.size(), progress.part(0.7, 1.0))) return {};
    if (ends.second <= ends.first) continue;  // once for both directions; an edge between equal ends only shrinks
    const auto backward = edges.find({ends.second, ends.first});
    if (backward == edges.end()) continue;
    EdgeEnd low, high;
    for (const HalfEdge h : forward) low.add(mesh, mesh.from(h)), high.add(mesh, mesh.to(h));
    for (const HalfEdge h : backward->second) low.add(mesh, mesh.to(h)), high.add(mesh, mesh.from(h));
    ClosingEdge edge;
    std::set<std::size_t> moved;
    for (const EdgeEnd& end : {low, high}) end.collect(goals, moved, edge.endPositions);
    if (moved.empty()) continue;
    edge.pairs.assign(moved.begin(), moved.end());
    closing.push_back(std::move(edge));
  }
  return closing;
}

VertexPairs closingPairs(const VertexPairs& pairs, const std::vector<ClosingEdge>& edges) {
  std::vector<bool> isIn(pairs.size(), false);
  for (const ClosingEdge& edge : edges)
    for (const std::size_t i : edge.pairs) isIn[i] = true;
  VertexPairs closing;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (isIn[i]) closing.push_back(pairs[i]);
  return closing;
}

VertexPairs withPartners(const VertexPairs& chosen, const VertexPairs& pairs, const std::vector<ClosingEdge>& edges) {
  const std::set<std::pair<Vertex, Vertex>> wanted(chosen.begin(), chosen.end());
  const auto isWanted = [&](std::size_t i) { return wanted.contains(pairs[i]); };
  const auto others = [&](const ClosingEdge& edge) {
    return edge.pairs.size() - std::ranges::count_if(edge.pairs, isWanted);
  };
  std::map<std::size_t, const ClosingEdge*> best;  // for each wanted pair, the edge that needs the fewest others
  for (const ClosingEdge& edge : edges) {
    for (const std::size_t i : edge.pairs) {
      if (!isWanted(i)) continue;
      const auto [at, isFirst] = best.try_emplace(i, &edge);
      if (!isFirst && others(edge) < others(*at->second)) at->second = &edge;
    }
  }
  std::set<std::pair<Vertex, Vertex>> all = wanted;
  for (const auto& [pair, edge] : best)
    for (const std::size_t i : edge->pairs) all.insert(pairs[i]);
  return {all.begin(), all.end()};
}

std::vector<std::vector<ClosingEdge>> connectedRuns(std::vector<ClosingEdge> edges, std::size_t pairs) {
  std::vector<std::vector<std::size_t>> with(pairs);  // the edges, by pair
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (const std::size_t i : edges[e].pairs) with[i].push_back(e);
  std::vector<std::vector<ClosingEdge>> runs;
  std::vector<bool> isTaken(edges.size(), false);
  for (std::size_t seed = 0; seed < edges.size(); ++seed) {
    if (isTaken[seed]) continue;
    std::vector<std::size_t> run{seed};
    isTaken[seed] = true;
    for (std::size_t k = 0; k < run.size(); ++k) {
      for (const std::size_t i : edges[run[k]].pairs) {
        for (const std::size_t e : std::exchange(with[i], {})) {
          if (!isTaken[e]) run.push_back(e);
          isTaken[e] = true;
        }
      }
    }
    std::vector<ClosingEdge>& connected = runs.emplace_back();
    for (const std::size_t e : run) connected.push_back(std::move(edges[e]));
  }
  return runs;
}

}  // namespace handwheel
