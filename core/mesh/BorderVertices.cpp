// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/BorderVertices.h"

#include "base/Tolerance.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

Box modelBox(const HalfEdgeMesh& mesh) {
  Box box;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    for (Vertex v : mesh.triangle(f)) box.extend(mesh.position(v));
  }
  return box;
}

}  // namespace

double modelDiagonal(const HalfEdgeMesh& mesh) {
  const Box box = modelBox(mesh);
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

BorderVertices::BorderVertices(const HalfEdgeMesh& mesh, const std::vector<bool>& without) {
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    if (mesh.isBorder(h)) m_vertices.insert(m_vertices.end(), {mesh.from(h), mesh.to(h)});
  }
  std::sort(m_vertices.begin(), m_vertices.end());
  m_vertices.erase(std::unique(m_vertices.begin(), m_vertices.end()), m_vertices.end());
  std::erase_if(m_vertices, [&](Vertex v) { return v < without.size() && without[v]; });
  if (m_vertices.empty()) return;

  const Box box = modelBox(mesh);
  m_origin = box.min();
  // About one vertex a cell if they were spread evenly over a surface; never below the tolerance, never over 2^10
  // cells.
  const double diagonal = box.diagonal().norm();
  const double perSide = std::min(1024.0, std::sqrt(static_cast<double>(m_vertices.size())) + 1.0);
  m_cellSize = std::max(diagonal / perSide, std::numeric_limits<double>::min());
  m_cells.reserve(m_vertices.size());
  for (Vertex v : m_vertices) m_cells.emplace(key(cellOf(mesh.position(v))), v);
}

BorderVertices::Cell BorderVertices::cellOf(const Vec3& p) const {
  Cell c;
  for (int k = 0; k < 3; ++k) c[static_cast<std::size_t>(k)] = static_cast<int>((p[k] - m_origin[k]) / m_cellSize);
  return c;
}

std::vector<std::pair<Vertex, Vertex>> nearBorderVertices(const HalfEdgeMesh& mesh, const std::vector<bool>& without) {
  const BorderVertices vertices(mesh, without);
  const double reach = tolerance::kNearWeld * modelDiagonal(mesh);
  std::vector<std::pair<Vertex, Vertex>> pairs;
  for (Vertex v : vertices.all()) {
    const Vec3 p = mesh.position(v);
    double best = reach * reach;
    Vertex nearest = kNone;
    vertices.forEachInBox(Box(p, p), [&](Vertex u) {
      if (u >= v) return;
      const double d = (mesh.position(u) - p).squaredNorm();
      if (d == 0.0 || d > best || (d == best && u > nearest)) return;
      best = d;
      nearest = u;
    });
    if (nearest != kNone) pairs.emplace_back(nearest, v);
  }
  return pairs;
}

}  // namespace handwheel
