// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/Stitching.h"

#include "mesh/boundary/PairMerging.h"
#include "mesh/boundary/TJunctions.h"
#include "mesh/structure/MeshBuilder.h"

#include <algorithm>
#include <optional>
#include <set>

namespace handwheel {
namespace {

struct MeshOpenness {
  std::size_t border = 0;
  std::size_t nonManifold = 0;

  bool improvesOn(const MeshOpenness& before) const {
    return border < before.border && nonManifold <= before.nonManifold;
  }
};

// Relinks the mesh.
MeshOpenness relinked(HalfEdgeMesh& mesh, Progress progress) {
  const BuildReport report = relink(mesh, progress);
  MeshOpenness o;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) o.border += mesh.isBorder(h);
  o.nonManifold = report.nonManifoldEdges + report.unpairedHalfEdges;
  return o;
}

// A mesh with its known properties.
class Stitcher {
 public:
  explicit Stitcher(HalfEdgeMesh& mesh) : m_mesh(mesh) {}

  // Relinks the trial, and keeps it if it is better.
  bool keepIfBetter(HalfEdgeMesh trial, Progress progress) {
    if (!m_openness) {
      HalfEdgeMesh unchanged = m_mesh;
      m_openness = relinked(unchanged, progress.part(0.0, 0.5));
    }
    const MeshOpenness after = relinked(trial, progress.part(0.5, 1.0));
    if (progress.cancelled() || !after.improvesOn(*m_openness)) return false;
    m_mesh = std::move(trial);
    m_openness = after;
    return true;
  }

 private:
  HalfEdgeMesh& m_mesh;
  std::optional<MeshOpenness> m_openness;
};

// The edges that close after border edges are split at the vertices on them.
struct SplitClosing {
  VertexPairs pairs;  // with vertices that only the split mesh has
  VertexPairs near;
  std::vector<ClosingEdge> edges;

  // Returns the end positions of the edges that need one of these pairs.
  std::set<PointKey> endPositionsOf(const VertexPairs& chosen) const {
    const std::set<std::pair<Vertex, Vertex>> wanted(chosen.begin(), chosen.end());
    std::set<PointKey> positions;
    for (const ClosingEdge& edge : edges) {
      const auto isWanted = [&](std::size_t i) { return wanted.contains(near[i]); };
      if (std::any_of(edge.pairs.begin(), edge.pairs.end(), isWanted))
        positions.insert(edge.endPositions.begin(), edge.endPositions.end());
    }
    return positions;
  }
};

SplitClosing closingWhenSplit(const HalfEdgeMesh& mesh, double nearWeld, Progress progress) {
  HalfEdgeMesh split = mesh;
  if (splitTJunctions(split, {}, progress.part(0.0, 0.5), nearWeld) == 0) return {};
  SplitClosing closing;
  closing.near = nearBoundaryVertices(split, {}, nearWeld, progress.part(0.5, 0.9));
  closing.edges = closingEdges(split, closing.near, progress.part(0.9, 1.0));
  closing.pairs = closingPairs(closing.near, closing.edges);
  return closing;
}

}  // namespace

std::vector<Vertex> stitchBoundaries(HalfEdgeMesh& mesh, const std::vector<bool>& fixed, Progress progress,
                                     double nearWeld) {
  Stitcher stitcher(mesh);
  const std::size_t vertices = mesh.vertexSlots();
  const VertexPairs near = nearBoundaryVertices(mesh, fixed, nearWeld, progress.part(0.0, 0.15));
  HalfEdgeMesh trial = mesh;
  std::vector<Vertex> moved = mergeClosingPairs(trial, near, progress.part(0.15, 0.3));
  if (!moved.empty() && !stitcher.keepIfBetter(std::move(trial), progress.part(0.3, 0.5))) moved.clear();
  trial = mesh;
  if (progress.cancelled() || splitTJunctions(trial, fixed, progress.part(0.5, 0.7), nearWeld) == 0) return moved;
  const VertexPairs nearThen = nearBoundaryVertices(trial, fixed, nearWeld, progress.part(0.7, 0.75));
  std::vector<Vertex> movedThen = mergeClosingPairs(trial, nearThen, progress.part(0.75, 0.8));
  if (!stitcher.keepIfBetter(std::move(trial), progress.part(0.8, 1.0))) return moved;
  std::erase_if(movedThen, [&](Vertex v) { return v >= vertices; });
  moved.insert(moved.end(), movedThen.begin(), movedThen.end());
  return moved;
}

VertexPairs stitchablePairs(const HalfEdgeMesh& mesh, double nearWeld, Progress progress) {
  const VertexPairs near = nearBoundaryVertices(mesh, {}, nearWeld, progress.part(0.0, 0.4));
  VertexPairs found = closingPairs(near, closingEdges(mesh, near, progress.part(0.4, 0.5)));
  if (found.size() == near.size()) return found;
  const VertexPairs more = closingWhenSplit(mesh, nearWeld, progress.part(0.5, 1.0)).pairs;
  for (const auto& pair : more)
    if (pair.second < mesh.vertexSlots()) found.push_back(pair);
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return std::pair(a.second, a.first) < std::pair(b.second, b.first); });
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<bool> fixedBut(const HalfEdgeMesh& mesh, const VertexPairs& chosen, double nearWeld, Progress progress) {
  const VertexPairs near = nearBoundaryVertices(mesh, {}, nearWeld, progress.part(0.0, 0.4));
  const std::vector<ClosingEdge> edges = closingEdges(mesh, near, progress.part(0.4, 0.5));
  std::vector<bool> fixed(mesh.vertexSlots(), true);
  const auto free = [&](Vertex v) {
    if (v < fixed.size()) fixed[v] = false;
  };
  for (const auto& [a, b] : withPartners(chosen, near, edges)) free(a), free(b);
  const VertexPairs plain = closingPairs(near, edges);
  const std::set<std::pair<Vertex, Vertex>> known(plain.begin(), plain.end());
  if (std::all_of(chosen.begin(), chosen.end(), [&](const auto& pair) { return known.contains(pair); })) return fixed;
  const std::set<PointKey> positions = closingWhenSplit(mesh, nearWeld, progress.part(0.5, 1.0)).endPositionsOf(chosen);
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    if (!mesh.isBorder(h)) continue;
    const Vertex from = mesh.from(h), to = mesh.to(h);
    if (positions.contains(positionKey(mesh.position(from))) || positions.contains(positionKey(mesh.position(to))))
      free(from), free(to);  // an edge is split only where both of its ends are free
  }
  return fixed;
}

}  // namespace handwheel
