// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/EdgeTable.h"

#include <algorithm>

namespace handwheel {

EdgeTable::EdgeTable(std::span<const Triangle> triangles, std::size_t vertexCount, Progress progress)
    : m_starts(vertexCount + 1, 0) {
  if (!fill(triangles, vertexCount, progress)) m_starts.clear();
}

// Returns false if cancelled.
bool EdgeTable::fill(std::span<const Triangle> triangles, std::size_t vertexCount, Progress progress) {
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    if (!pollProgress(f, triangles.size(), progress.part(0.0, 0.2))) return false;
    const Triangle& t = triangles[f];
    if (hasRepeatedVertex(t)) continue;
    for (int k = 0; k < 3; ++k) ++m_starts[std::min(t[k], t[(k + 1) % 3]) + 1];
  }
  for (std::size_t v = 0; v < vertexCount; ++v) m_starts[v + 1] += m_starts[v];

  m_entries.resize(m_starts.back());
  std::vector<std::size_t> next(m_starts.begin(), m_starts.end() - 1);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    if (!pollProgress(f, triangles.size(), progress.part(0.2, 0.6))) return false;
    const Triangle& t = triangles[f];
    if (hasRepeatedVertex(t)) continue;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      m_entries[next[low]++] = {high, static_cast<std::uint32_t>(3 * f) + k};
    }
  }
  for (std::size_t v = 0; v < vertexCount; ++v) {
    if (!pollProgress(v, vertexCount, progress.part(0.6, 1.0))) return false;
    std::sort(m_entries.begin() + static_cast<std::ptrdiff_t>(m_starts[v]),
              m_entries.begin() + static_cast<std::ptrdiff_t>(m_starts[v + 1]), [](const Entry& a, const Entry& b) {
                return a.high != b.high ? a.high < b.high : a.halfEdge < b.halfEdge;
              });
  }
  return true;
}

}  // namespace handwheel
