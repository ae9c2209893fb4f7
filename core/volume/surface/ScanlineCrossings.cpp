// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/surface/ScanlineCrossings.h"

#include "proximity/ExactOrientation.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace handwheel {
namespace {

constexpr std::size_t kRowsAtOnce = 1024;

struct Found {
  int y, z;
  ScanlineCrossings::Crossing crossing;
};

Vec2 seenAlongX(const Vec3& p) {
  return {p.y(), p.z()};
}

// The side of a line on which a row lies, as if it were at (y + e, z + e²) for an infinitely small e. Opposite for the
// reversed line; 0 only if its ends coincide, and then the other two sides of a triangle are opposite.
int sideOfRow(const Vec2& from, const Vec2& to, const Vec2& row) {
  if (const int side = sideOfLine(from, to, row); side != 0) return side;
  if (from.y() != to.y()) return from.y() > to.y() ? 1 : -1;
  return (to.x() > from.x()) - (to.x() < from.x());
}

// The extent along y of a triangle seen along x, at this z, and a little more.
std::pair<double, double> extentAt(double z, const std::array<Vec2, 3>& seen) {
  constexpr double kMargin = 1e-6;  // voxels
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 &a = seen[k], &b = seen[(k + 1) % 3];
    if (std::max(a.y(), b.y()) < z - kMargin || std::min(a.y(), b.y()) > z + kMargin) continue;
    const double rise = b.y() - a.y();
    const bool isLevel = std::abs(rise) < kMargin;  // nearly: then all of the edge
    const double at = isLevel ? 0.0 : std::clamp((z - a.y()) / rise, 0.0, 1.0);
    const double from = isLevel ? std::min(a.x(), b.x()) : a.x() + at * (b.x() - a.x());
    const double to = isLevel ? std::max(a.x(), b.x()) : from;
    // Displacement of the point by a margin of z.
    const double slack = isLevel ? kMargin : kMargin * (1.0 + std::abs((b.x() - a.x()) / rise));
    low = std::min(low, from - slack);
    high = std::max(high, to + slack);
  }
  return {low, high};
}

// Calls found(y, z, x, step) for each of the rows that crosses the triangle.
template <class Visit>
void forEachCrossing(const std::array<Vec3, 3>& corners, const Eigen::AlignedBox2i& rows, const Progress& progress,
                     Visit found) {
  const std::array<Vec2, 3> seen{seenAlongX(corners[0]), seenAlongX(corners[1]), seenAlongX(corners[2])};
  const Vec2 low = seen[0].cwiseMin(seen[1]).cwiseMin(seen[2]), high = seen[0].cwiseMax(seen[1]).cwiseMax(seen[2]);
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double lowX = std::min({corners[0].x(), corners[1].x(), corners[2].x()});
  const double highX = std::max({corners[0].x(), corners[1].x(), corners[2].x()});
  const double highest = std::min<double>(high.y(), rows.max().y());
  for (int z = std::max(static_cast<int>(std::ceil(low.y())), rows.min().y()); z <= highest && !progress.cancelled();
       ++z) {
    const auto [from, to] = extentAt(z, seen);
    const double last = std::min({high.x(), to, static_cast<double>(rows.max().x())});
    for (int y = std::max(static_cast<int>(std::ceil(std::max(low.x(), from))), rows.min().x()); y <= last; ++y) {
      const Vec2 row(y, z);
      const int side = sideOfRow(seen[0], seen[1], row);
      if (side == 0 || sideOfRow(seen[1], seen[2], row) != side || sideOfRow(seen[2], seen[0], row) != side) continue;
      // In the triangle's plane, and within its extent where that is nearly parallel to the row.
      const Vec2 away = row - seen[0];
      const double x = corners[0].x() - (normal.y() * away.x() + normal.z() * away.y()) / normal.x();
      found(y, z, std::isfinite(x) ? std::clamp(x, lowX, highX) : lowX, -side);
    }
  }
}

}  // namespace

ScanlineCrossings::ScanlineCrossings(const TriangleSoup& closed, Progress progress,
                                     const std::optional<Eigen::AlignedBox2i>& within)
    : m_crossed(closed.triangles.size(), false) {
  constexpr int kMost = std::numeric_limits<int>::max();
  const Eigen::AlignedBox2i wanted =
      within.value_or(Eigen::AlignedBox2i(Eigen::Vector2i::Constant(-kMost), Eigen::Vector2i::Constant(kMost)));
  tbb::enumerable_thread_specific<std::vector<Found>> found;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, closed.triangles.size()),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      std::vector<Found>& mine = found.local();
                      for (std::size_t i = range.begin(); i < range.end(); ++i) {
                        const Triangle& t = closed.triangles[i];
                        forEachCrossing({closed.points[t[0]], closed.points[t[1]], closed.points[t[2]]}, wanted,
                                        progress, [&](int y, int z, double x, int step) {
                                          mine.push_back({y, z, {x, step, static_cast<std::uint32_t>(i)}});
                                        });
                      }
                    });
  if (progress.cancelled()) return;
  for (const std::vector<Found>& some : found)
    for (const Found& f : some) m_range.extend(Eigen::Vector2i(f.y, f.z));
  if (m_range.isEmpty()) return;

  // Counted, then placed by rows.
  const auto width = static_cast<std::size_t>(m_range.sizes().x() + 1);
  const std::size_t rows = width * static_cast<std::size_t>(m_range.sizes().y() + 1);
  const auto rowOf = [&](int y, int z) {
    return static_cast<std::size_t>(z - m_range.min().y()) * width + static_cast<std::size_t>(y - m_range.min().x());
  };
  m_begin.assign(rows + 2, 0);
  for (const std::vector<Found>& some : found)
    for (const Found& f : some) ++m_begin[rowOf(f.y, f.z) + 2];
  for (std::size_t i = 2; i < m_begin.size(); ++i) m_begin[i] += m_begin[i - 1];
  m_crossings.resize(m_begin.back());
  for (const std::vector<Found>& some : found)
    for (const Found& f : some) m_crossings[m_begin[rowOf(f.y, f.z) + 1]++] = f.crossing;
  m_begin.pop_back();

  m_after.resize(m_crossings.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rows, kRowsAtOnce),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t row = range.begin(); row < range.end(); ++row) {
                        const auto begin = m_begin[row], end = m_begin[row + 1];
                        std::sort(m_crossings.begin() + static_cast<std::ptrdiff_t>(begin),
                                  m_crossings.begin() + static_cast<std::ptrdiff_t>(end));
                        int winding = 0;
                        for (std::size_t i = begin; i < end; ++i) m_after[i] = winding += m_crossings[i].step;
                      }
                    });
  for (std::size_t i = 0; i < m_crossings.size(); ++i) {
    const int after = m_after[i];
    m_crossed[m_crossings[i].triangle] = true;
    if (after < 0 || after > 1) m_isSimple = false;
    m_mostTurns = std::max(m_mostTurns, after);
  }
}

ScanlineCrossings::Bounding ScanlineCrossings::boundingBy(const Turns& turns) const {
  Bounding found{std::vector<bool>(m_crossed.size(), false), {}};
  if (m_range.isEmpty()) return found;
  const auto width = static_cast<std::size_t>(m_range.sizes().x() + 1);
  const auto pointOf = [&](std::size_t row, std::size_t i) {
    return Vec3(m_crossings[i].x, static_cast<double>(row % width) + m_range.min().x(),
                static_cast<double>(row / width) + m_range.min().y());
  };
  std::vector<char> isBounding(m_crossings.size(), 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, m_begin.size() - 1, kRowsAtOnce),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t row = range.begin(); row < range.end(); ++row)
                        for (std::size_t i = m_begin[row]; i < m_begin[row + 1]; ++i) {
                          const double after = turns(pointOf(row, i), m_after[i]);
                          isBounding[i] = (after > 0.5) != (after - m_crossings[i].step > 0.5);
                        }
                    });
  for (std::size_t row = 0; row + 1 < m_begin.size(); ++row)
    for (std::size_t i = m_begin[row]; i < m_begin[row + 1]; ++i) {
      if (!isBounding[i]) continue;
      found.triangles[m_crossings[i].triangle] = true;
      found.points.emplace_back(pointOf(row, i), m_crossings[i].triangle);
    }
  return found;
}

std::span<const ScanlineCrossings::Crossing> ScanlineCrossings::row(int y, int z) const {
  if (!m_range.contains(Eigen::Vector2i(y, z))) return {};
  const auto width = static_cast<std::size_t>(m_range.sizes().x() + 1);
  const std::size_t row =
      static_cast<std::size_t>(z - m_range.min().y()) * width + static_cast<std::size_t>(y - m_range.min().x());
  return std::span(m_crossings).subspan(m_begin[row], m_begin[row + 1] - m_begin[row]);
}

std::size_t ScanlineCrossings::bytes() const {
  return sizeof *this + m_begin.size() * sizeof m_begin[0] +
         m_crossings.size() * (sizeof m_crossings[0] + sizeof m_after[0]) + m_crossed.size() / 8;
}

int ScanlineCrossings::winding(const VoxelIndex& voxel) const {
  const std::span<const Crossing> crossings = row(voxel.y(), voxel.z());
  const double x = voxel.x();
  const auto after =
      std::upper_bound(crossings.begin(), crossings.end(), x, [](double at, const Crossing& c) { return at < c.x; });
  if (after == crossings.begin()) return 0;
  const auto last = static_cast<std::size_t>(&*std::prev(after) - m_crossings.data());
  return m_after[last];
}

}  // namespace handwheel
