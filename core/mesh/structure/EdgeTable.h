// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "mesh/structure/CancelPolling.h"

#include <span>
#include <vector>

namespace handwheel {

// The undirected edges of a triangle list, with their half-edges. An edge has the half-edges (3 · triangle + corner)
// along it in both directions. Triangles with a repeated vertex are omitted. The table is built in O(n) by bucketing
// half-edges at their smaller vertex.
class EdgeTable {
 public:
  struct Entry {
    std::uint32_t high;  // the edge's larger vertex
    std::uint32_t halfEdge;
  };

  // The table is invalid if cancelled, though safe to iterate.
  EdgeTable(std::span<const Triangle> triangles, std::size_t vertexCount, Progress progress = {});

  // Calls visit(low, high, span of entries) for each edge, in order of (low, high), until cancelled.
  template <class Visit>
  void forEachEdge(Visit visit, Progress progress = {}) const {
    for (std::uint32_t low = 0; low + 1 < m_starts.size(); ++low) {
      if (!pollProgress(low, m_starts.size(), progress)) return;
      for (std::size_t i = m_starts[low]; i < m_starts[low + 1];) {
        std::size_t end = i + 1;
        while (end < m_starts[low + 1] && m_entries[end].high == m_entries[i].high) ++end;
        visit(low, m_entries[i].high, std::span<const Entry>(&m_entries[i], end - i));
        i = end;
      }
    }
  }

 private:
  bool fill(std::span<const Triangle> triangles, std::size_t vertexCount, Progress progress);

  std::vector<std::size_t> m_starts;  // index of the first entry of each smaller vertex
  std::vector<Entry> m_entries;
};

inline bool hasRepeatedVertex(const Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

}  // namespace handwheel
