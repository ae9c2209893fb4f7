// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/search/PointInPolygonTester.h"

#include <algorithm>
#include <utility>

namespace handwheel {
namespace {

// A lasso has some hundred corners: a handful to the row.
constexpr std::size_t kRows = 128;

}  // namespace

PointInPolygonTester::PointInPolygonTester(std::span<const Vec2> corners) {
  if (corners.empty()) return;
  m_low = m_high = corners.front().y();
  for (const Vec2& p : corners) {
    m_low = std::min(m_low, p.y());
    m_high = std::max(m_high, p.y());
  }
  if (!(m_high > m_low)) return;  // nothing is inside
  m_rowsPerUnit = static_cast<double>(kRows) / (m_high - m_low);

  std::vector<std::vector<Edge>> rows(kRows);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Edge edge{corners[i], corners[(i + 1) % corners.size()]};
    if (edge.low.y() > edge.high.y()) std::swap(edge.low, edge.high);
    if (edge.low.y() == edge.high.y()) continue;
    for (std::size_t k = row(edge.low.y()); k <= row(edge.high.y()); ++k) rows[k].push_back(edge);
  }
  for (const std::vector<Edge>& edges : rows) {
    m_first.push_back(static_cast<std::uint32_t>(m_edges.size()));
    m_edges.insert(m_edges.end(), edges.begin(), edges.end());
  }
  m_first.push_back(static_cast<std::uint32_t>(m_edges.size()));
}

std::size_t PointInPolygonTester::row(double y) const {
  const double at = (y - m_low) * m_rowsPerUnit;
  if (!(at > 0.0)) return 0;  // also for a height that overflows
  return at < static_cast<double>(kRows) ? static_cast<std::size_t>(at) : kRows - 1;
}

bool PointInPolygonTester::contains(const Vec2& p) const {
  if (m_edges.empty() || !(p.y() >= m_low && p.y() < m_high)) return false;
  const std::size_t at = row(p.y());
  bool inside = false;
  for (std::uint32_t i = m_first[at]; i < m_first[at + 1]; ++i) {
    const auto& [low, high] = m_edges[i];
    if (p.y() < low.y() || p.y() >= high.y()) continue;
    const double x = low.x() + (p.y() - low.y()) / (high.y() - low.y()) * (high.x() - low.x());
    if (p.x() < x) inside = !inside;
  }
  return inside;
}

}  // namespace handwheel
