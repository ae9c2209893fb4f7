// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/path/PathPicture.h"

#include <algorithm>
#include <limits>

namespace handwheel {

namespace {

constexpr double kDash = 12.0;                                  // mm, dashes of travel
constexpr double kPathArrow = 15.0, kPathArrowHalfWidth = 5.0;  // mm
constexpr double kArrowsApart = 60.0, kDotsApart = 5.0;         // mm, at least

// Adds two barbed lines across each other, which look like an arrow from all sides.
void addArrow(const Vec3& middle, const Vec3& direction, PathLine::Look look, std::vector<PathLine>& lines) {
  const Vec3 tip = middle + 0.5 * kPathArrow * direction, end = tip - kPathArrow * direction;
  const Vec3 side = kPathArrowHalfWidth * direction.unitOrthogonal();
  for (const Vec3& aside : {side, Vec3(direction.cross(side))})
    lines.push_back({{end + aside, tip, end - aside}, look});
}

// The path of a leg between the points from `begin` to before `end`, with the one before it.
class Leg {
 public:
  Leg(std::span<const PathPoint> points, std::size_t begin, std::size_t end)
      : m_points(points), m_begin(begin), m_end(end) {
    for (std::size_t i = begin; i < end; ++i) m_length += pieceTo(i).norm();
  }
  double length() const { return m_length; }
  void addArrowInTheMiddle(std::vector<PathLine>& lines) const {
    double rest = 0.5 * m_length;
    for (std::size_t i = m_begin; i < m_end; ++i) {
      const Vec3 piece = pieceTo(i);
      const double length = piece.norm();
      if (length > 0.0 && rest <= length)
        return addArrow(m_points[i - 1].at + rest / length * piece, piece / length, m_points[i].look, lines);
      rest -= length;
    }
  }

 private:
  Vec3 pieceTo(std::size_t i) const { return m_points[i].at - m_points[i - 1].at; }

  std::span<const PathPoint> m_points;
  std::size_t m_begin, m_end;
  double m_length = 0.0;  // mm
};

std::vector<PathLine> linesThrough(std::span<const PathPoint> points) {
  std::vector<PathLine> runs, lines;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (runs.empty() || runs.back().look != points[i].look) runs.push_back({{points[i - 1].at}, points[i].look});
    runs.back().points.push_back(points[i].at);
  }
  for (PathLine& run : runs) {
    if (run.look != PathLine::Look::Travel) {
      lines.push_back(std::move(run));
      continue;
    }
    for (PathLine& dash : dashed(run, kDash)) lines.push_back(std::move(dash));
  }
  return lines;
}

}  // namespace

std::vector<PathLine> pathPicture(std::span<const PathPoint> given) {
  std::vector<PathPoint> points(given.begin(), given.end());
  std::erase_if(points, [](const PathPoint& point) { return !point.at.allFinite(); });
  std::vector<PathLine> lines = linesThrough(points);
  if (points.empty()) return lines;
  Vec3 dot = points.front().at;
  lines.push_back({{dot}, PathLine::Look::Waypoint});
  double travelled = 0.0, arrowAt = -std::numeric_limits<double>::infinity();
  for (std::size_t begin = 1, end = 1; begin < points.size(); begin = end) {
    while (end < points.size() && points[end].leg == points[begin].leg) ++end;
    const Leg leg(points, begin, end);
    const double middle = travelled + 0.5 * leg.length();
    if (leg.length() > 0.0 && middle - arrowAt >= kArrowsApart) {
      leg.addArrowInTheMiddle(lines);
      arrowAt = middle;
    }
    travelled += leg.length();
    const Vec3& last = points[end - 1].at;
    if (end < points.size() && (last - dot).norm() < kDotsApart) continue;
    dot = last;
    lines.push_back({{dot}, PathLine::Look::Waypoint});
  }
  std::ranges::stable_sort(lines, {}, &PathLine::look);
  return lines;
}

}  // namespace handwheel
