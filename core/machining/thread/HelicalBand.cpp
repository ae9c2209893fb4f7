// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/thread/HelicalBand.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kInRing = 1e-6;  // mm; a row this near to a ring is in it

// Heights of rows above the middle of a groove, within one pitch, rising: the edges of bottom and crest, three in each
// rounding, and some between.
std::vector<double> rowsWithinPitch(const ThreadGroove& groove, double surface) {
  const ThreadCut& cut = groove.cut();
  const double half = 0.5 * cut.pitch, nose = groove.noseRadius();
  const double height = std::max(0.0, std::abs(surface - groove.deepest()));
  std::vector<double> distances{0.0, 0.5 * cut.flat, cut.distanceAt(height, nose), half};
  const double rounding = nose * std::cos(0.5 * cut.angle);
  for (const double share : {0.25, 0.5, 0.75, 1.0}) distances.push_back(0.5 * cut.flat + share * rounding);
  for (int k = 1; k < 8; ++k) distances.push_back(half * k / 8.0);
  std::sort(distances.begin(), distances.end());
  const double least = 1e-3 * cut.pitch;
  std::vector<double> rows;
  for (const double distance : distances) {
    if (distance > half - least && distance != half) continue;
    if (rows.empty() || distance > rows.back() + least) rows.push_back(distance);
  }
  for (std::size_t i = rows.size() - 1; i-- > 1;) rows.push_back(-rows[i]);
  std::sort(rows.begin(), rows.end());
  return rows;
}

class HelicalBand {
 public:
  HelicalBand(TriangleSoup& soup, const std::vector<ProfilePoint>& circle, const PartThreads& threads,
              const ThreadGroove& along, const SurfaceRing& lower, const SurfaceRing& upper)
      : m_soup(soup),
        m_circle(circle),
        m_threads(threads),
        m_groove(along),
        m_lower(lower),
        m_upper(upper),
        m_columns(static_cast<std::uint32_t>(circle.size())),
        m_rows(rowsWithinPitch(along, 0.5 * (lower.radius + upper.radius))) {}

  void build() {
    for (std::uint32_t k = 0; k < m_columns; ++k) m_column.push_back(points(k));
    for (std::uint32_t k = 0; k < m_columns; ++k) join(k);
  }

 private:
  // The rows between the rings in one direction.
  struct Column {
    std::int64_t firstRow = 0, endRow = 0;
    std::uint32_t firstPoint = 0;
  };

  double height(std::uint32_t column, std::int64_t row) const {
    const auto count = static_cast<std::int64_t>(m_rows.size());
    const std::int64_t groove = row >= 0 ? row / count : -((count - 1 - row) / count);
    const double turn = static_cast<double>(column) / static_cast<double>(m_columns);
    return m_groove.cut().offset + m_groove.cut().pitch * static_cast<double>(groove) +
           m_rows[static_cast<std::size_t>(row - groove * count)] + m_groove.cut().rise() * turn;
  }

  // Returns the first row above a height.
  std::int64_t rowAbove(std::uint32_t column, double z) const {
    const double grooves = (z - height(column, 0)) / m_groove.cut().pitch;
    auto row = static_cast<std::int64_t>(std::floor(grooves) - 1.0) * static_cast<std::int64_t>(m_rows.size());
    while (!(height(column, row) > z)) ++row;
    return row;
  }

  Column points(std::uint32_t column) {
    Column made;
    made.firstPoint = static_cast<std::uint32_t>(m_soup.points.size());
    made.firstRow = rowAbove(column, m_lower.z + kInRing);
    made.endRow = std::max(made.firstRow, rowAbove(column, m_upper.z - kInRing));
    const double angle = 2.0 * M_PI * column / m_columns;
    for (std::int64_t row = made.firstRow; row < made.endRow; ++row) {
      const double z = height(column, row), t = (z - m_lower.z) / (m_upper.z - m_lower.z);
      const double radius = m_threads.radius(m_groove.side(), std::lerp(m_lower.radius, m_upper.radius, t),
                                             std::lerp(m_lower.otherSide, m_upper.otherSide, t), z, angle);
      m_soup.points.emplace_back(radius * m_circle[column].x(), radius * m_circle[column].y(), z);
    }
    return made;
  }

  std::uint32_t point(std::uint32_t column, std::int64_t row) const {
    const Column& of = m_column[column];
    if (row < of.firstRow) return m_lower.first + column;
    if (row >= of.endRow) return m_upper.first + column;
    return of.firstPoint + static_cast<std::uint32_t>(row - of.firstRow);
  }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a == b || b == c || c == a) return;
    if (m_groove.side() == TurningSide::Bore) std::swap(b, c);
    m_soup.triangles.push_back({a, b, c});
  }

  // Adds the strip from a column to the next. After the last comes the first, a turn higher up the helix.
  void join(std::uint32_t column) {
    const bool isLast = column + 1 == m_columns;
    const std::uint32_t next = isLast ? 0 : column + 1;
    const auto turn = static_cast<std::int64_t>(m_rows.size()) * m_groove.cut().starts;
    const std::int64_t shift = !isLast ? 0 : m_groove.cut().isLeft ? -turn : turn;
    const Column &here = m_column[column], &there = m_column[next];
    const std::int64_t first = std::min(here.firstRow, there.firstRow - shift) - 1;
    const std::int64_t end = std::max(here.endRow, there.endRow - shift);
    for (std::int64_t row = first; row < end; ++row) {
      const std::uint32_t a = point(column, row), b = point(next, row + shift);
      const std::uint32_t c = point(next, row + 1 + shift), d = point(column, row + 1);
      add(a, b, c);
      add(a, c, d);
    }
  }

  TriangleSoup& m_soup;
  const std::vector<ProfilePoint>& m_circle;
  const PartThreads& m_threads;
  const ThreadGroove& m_groove;
  const SurfaceRing &m_lower, &m_upper;
  std::uint32_t m_columns;
  std::vector<double> m_rows;  // mm, above the middle of a groove, within one pitch
  std::vector<Column> m_column;
};

}  // namespace

void addHelicalBand(TriangleSoup& soup, const std::vector<ProfilePoint>& circle, const PartThreads& threads,
                    const ThreadGroove& along, const SurfaceRing& lower, const SurfaceRing& upper) {
  HelicalBand(soup, circle, threads, along, lower, upper).build();
}

}  // namespace handwheel
