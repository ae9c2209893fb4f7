// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace handwheel {

// A union-find structure with path halving.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : m_parent(n) { std::iota(m_parent.begin(), m_parent.end(), 0u); }

  std::uint32_t root(std::uint32_t a) {
    while (m_parent[a] != a) a = m_parent[a] = m_parent[m_parent[a]];
    return a;
  }
  void join(std::uint32_t a, std::uint32_t b) { m_parent[root(a)] = root(b); }

 private:
  std::vector<std::uint32_t> m_parent;
};

}  // namespace handwheel
