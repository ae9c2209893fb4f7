// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/PairMerging.h"

#include "mesh/structure/CancelPolling.h"

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <map>
#include <set>
#include <utility>

namespace handwheel {
namespace {

// The openness that relink() would give the edges at some positions.
struct Openness {
  std::size_t border = 0;
  std::size_t nonManifold = 0;  // edges, and the half-edges that find no partner there

  bool improvesOn(const Openness& before) const { return border < before.border && nonManifold <= before.nonManifold; }
};

class PairMerger {
 public:
  PairMerger(HalfEdgeMesh& mesh, const VertexPairs& pairs, Progress progress) : m_mesh(mesh), m_pairs(pairs) {
    for (const auto& [first, second] : pairs)
      for (const Vertex v : {first, second}) m_facesAt[positionKey(mesh.position(v))];
    for (Face f = 0; f < mesh.faceSlots(); ++f) {
      if (!pollProgress(f, mesh.faceSlots(), progress)) return;
      if (!mesh.isProper(f)) continue;
      for (const Vertex v : mesh.triangle(f)) {
        const auto at = m_facesAt.find(positionKey(mesh.position(v)));
        if (at != m_facesAt.end()) at->second.push_back(f);
      }
    }
  }

  // Returns false, without a change, if that closes nothing or harms an edge.
  bool merge(std::span<const ClosingEdge> edges) {
    std::set<std::size_t> indices;
    for (const ClosingEdge& edge : edges) indices.insert(edge.pairs.begin(), edge.pairs.end());
    std::set<PointKey> positions;
    std::vector<Move> moves;
    for (const std::size_t i : indices) {
      const auto& [first, second] = m_pairs[i];
      for (const Vertex v : {first, second}) positions.insert(positionKey(m_mesh.position(v)));
    }
    const std::set<Face> faces = facesAt(positions);
    const Openness before = openness(faces, positions);
    for (const std::size_t i : indices) {  // the first vertex of a chain is moved before the next follows it
      const auto& [first, second] = m_pairs[i];
      const Vec3 goal = m_mesh.position(first);
      if (goal == m_mesh.position(second)) continue;
      moves.push_back({second, m_mesh.position(second)});
      m_mesh.setPosition(second, goal);
    }
    if (!openness(faces, positions).improvesOn(before)) {
      for (const Move& move : moves) m_mesh.setPosition(move.vertex, move.from);
      return false;
    }
    for (const Move& move : moves) settle(move);
    return true;
  }

  const std::vector<Vertex>& moved() const { return m_moved; }

 private:
  struct Move {
    Vertex vertex;
    Vec3 from;
  };

  std::set<Face> facesAt(const std::set<PointKey>& positions) const {
    std::set<Face> faces;
    for (const PointKey& position : positions) {
      const std::vector<Face>& at = m_facesAt.at(position);
      faces.insert(at.begin(), at.end());
    }
    return faces;
  }

  bool hasShrunk(Face f) const {
    const TrianglePoints p = m_mesh.points(f);
    return p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
  }

  // Returns the openness of the edges with an end at one of these positions. faces are all faces with a corner there.
  Openness openness(const std::set<Face>& faces, const std::set<PointKey>& positions) const {
    std::map<EdgeKey, std::pair<int, int>> edges;  // half-edges in each direction
    for (const Face f : faces) {
      if (hasShrunk(f)) continue;
      for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
        const PointKey from = positionKey(m_mesh.position(m_mesh.from(h)));
        const PointKey to = positionKey(m_mesh.position(m_mesh.to(h)));
        if (!positions.contains(from) && !positions.contains(to)) continue;
        auto& [forward, backward] = edges[from < to ? EdgeKey{from, to} : EdgeKey{to, from}];
        ++(from < to ? forward : backward);
      }
    }
    Openness open;
    for (const auto& [ends, halfEdges] : edges) {
      const int count = halfEdges.first + halfEdges.second;
      open.border += count == 1;
      open.nonManifold += count > 2;
      if (count > 1) open.nonManifold += static_cast<std::size_t>(std::abs(halfEdges.first - halfEdges.second));
    }
    return open;
  }

  // Records that the vertex keeps its new position.
  void settle(const Move& move) {
    m_moved.push_back(move.vertex);
    std::vector<Face>& left = m_facesAt.at(positionKey(move.from));
    std::vector<Face>& arrived = m_facesAt.at(positionKey(m_mesh.position(move.vertex)));
    std::vector<Face> all = std::exchange(left, {});
    for (const Face f : all) {
      const Triangle t = m_mesh.triangle(f);
      const bool isMoved = std::find(t.begin(), t.end(), move.vertex) != t.end();
      if (isMoved && hasShrunk(f)) {
        m_gone.insert(f);
      } else {
        (isMoved ? arrived : left).push_back(f);
      }
    }
  }

 public:
  // Removes the faces that merging reduced to an edge or a point.
  void removeShrunk() {
    for (const Face f : m_gone) m_mesh.removeFace(f);
  }

 private:
  HalfEdgeMesh& m_mesh;
  const VertexPairs& m_pairs;
  std::map<PointKey, std::vector<Face>> m_facesAt;  // the vertices of the pairs, also while they are moved
  std::set<Face> m_gone;
  std::vector<Vertex> m_moved;
};

}  // namespace

std::vector<Vertex> mergeClosingPairs(HalfEdgeMesh& mesh, const VertexPairs& pairs, Progress progress) {
  const std::vector<ClosingEdge> edges = closingEdges(mesh, pairs, progress.part(0.0, 0.4));
  if (edges.empty() || progress.cancelled()) return {};
  PairMerger merger(mesh, pairs, progress.part(0.4, 0.8));
  const std::vector<std::vector<ClosingEdge>> runs = connectedRuns(edges, pairs.size());
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (!pollProgress(r, runs.size(), progress.part(0.8, 1.0), 1)) break;
    std::deque<std::span<const ClosingEdge>> trials{runs[r]};
    for (; !trials.empty() && !progress.cancelled(); trials.pop_front()) {
      const std::span<const ClosingEdge> trial = trials.front();
      if (merger.merge(trial) || trial.size() == 1) continue;
      trials.push_back(trial.first(trial.size() / 2));
      trials.push_back(trial.subspan(trial.size() / 2));
    }
  }
  merger.removeShrunk();
  return merger.moved();
}

}  // namespace handwheel
