// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HalfEdgeMesh.h"

#include <array>
#include <unordered_map>
#include <utility>
#include <vector>

namespace handwheel {

// Length of the diagonal of the box around all live faces; 0 for an empty mesh.
double modelDiagonal(const HalfEdgeMesh& mesh);

// The vertices on open borders, in a grid for finding those near a place.
class BorderVertices {
 public:
  // Vertices marked in "without" are left out; it may be shorter than the number of vertices.
  explicit BorderVertices(const HalfEdgeMesh& mesh, const std::vector<bool>& without = {});

  std::size_t size() const { return m_vertices.size(); }
  const std::vector<Vertex>& all() const { return m_vertices; }

  // Calls visit(vertex) for at least all vertices within kNearWeld of the box.
  template <class Visit>
  void forEachInBox(const Box& box, Visit visit) const {
    if (m_vertices.empty()) return;
    const Cell low = cellOf(box.min()), high = cellOf(box.max());
    double cells = 1.0;
    for (std::size_t k = 0; k < 3; ++k) cells *= high[k] - low[k] + 3;
    if (cells > static_cast<double>(m_vertices.size())) {
      for (Vertex v : m_vertices) visit(v);
      return;
    }
    for (int x = low[0] - 1; x <= high[0] + 1; ++x) {
      for (int y = low[1] - 1; y <= high[1] + 1; ++y) {
        for (int z = low[2] - 1; z <= high[2] + 1; ++z) {
          const auto [begin, end] = m_cells.equal_range(key({x, y, z}));
          for (auto it = begin; it != end; ++it) visit(it->second);
        }
      }
    }
  }

 private:
  using Cell = std::array<int, 3>;
  static std::uint64_t key(const Cell& c) {
    return (static_cast<std::uint64_t>(c[0] & 0x1fffff) << 42) | (static_cast<std::uint64_t>(c[1] & 0x1fffff) << 21) |
           static_cast<std::uint64_t>(c[2] & 0x1fffff);
  }
  Cell cellOf(const Vec3& p) const;

  std::vector<Vertex> m_vertices;
  Vec3 m_origin = Vec3::Zero();
  double m_cellSize = 1.0;
  std::unordered_multimap<std::uint64_t, Vertex> m_cells;
};

// Pairs of vertices on open borders that are apart, but nearer than tolerance::kNearWeld of the model's diagonal: most
// often one vertex of the scan that its file rounded apart. Each is paired with its nearest of smaller number. Vertices
// marked in "without" take no part.
std::vector<std::pair<Vertex, Vertex>> nearBorderVertices(const HalfEdgeMesh& mesh,
                                                          const std::vector<bool>& without = {});

}  // namespace handwheel
