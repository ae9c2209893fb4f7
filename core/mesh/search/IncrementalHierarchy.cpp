// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/search/IncrementalHierarchy.h"

#include <utility>

namespace handwheel {
namespace {

TriangleHierarchy hierarchyOf(const std::vector<TrianglePoints>& triangles) {
  std::vector<Vec3> points;
  std::vector<Triangle> corners;
  for (const TrianglePoints& t : triangles) {
    const auto n = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), t.begin(), t.end());
    corners.push_back({n, n + 1, n + 2});
  }
  return {points, corners};
}

}  // namespace

void IncrementalHierarchy::add(const TrianglePoints& t) {
  m_newest.push_back(t);
  if (m_newest.size() < kListLength) return;
  std::vector<TrianglePoints> merged = std::exchange(m_newest, {});
  std::size_t level = 0;
  for (; level < m_levels.size() && !m_levels[level].empty(); ++level) {
    const TriangleHierarchy full = std::exchange(m_levels[level], {});
    for (std::uint32_t i = 0; i < kListLength << level; ++i) merged.push_back(full.corners(i));
  }
  if (level == m_levels.size()) m_levels.emplace_back();
  m_levels[level] = hierarchyOf(merged);
}

}  // namespace handwheel
