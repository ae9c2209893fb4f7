// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/RoundedPolygon.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

bool isLower(const ProfilePoint& a, const ProfilePoint& b) {
  return a.y() < b.y() || (a.y() == b.y() && a.x() < b.x());
}

// Returns a positive value if a, b, c turn to the left, with z to the right and r up.
double turn(const ProfilePoint& a, const ProfilePoint& b, const ProfilePoint& c) {
  return (b.y() - a.y()) * (c.x() - a.x()) - (b.x() - a.x()) * (c.y() - a.y());
}

// Andrew's monotone chain (Andrew 1979). The points must be sorted; hull must have room for one more.
std::size_t hullOf(std::span<const ProfilePoint> sorted, std::span<ProfilePoint> hull) {
  if (sorted.size() < 3) {
    std::copy(sorted.begin(), sorted.end(), hull.begin());
    return sorted.size();
  }
  std::size_t count = 0;
  const auto add = [&](const ProfilePoint& p, std::size_t floor) {
    while (count >= floor + 2 && turn(hull[count - 2], hull[count - 1], p) <= 0.0) --count;
    hull[count++] = p;
  };
  for (const ProfilePoint& p : sorted) add(p, 0);
  const std::size_t lower = count - 1;
  for (std::size_t i = sorted.size() - 1; i-- > 0;) add(sorted[i], lower);
  return count - 1;  // the first point is repeated
}

}  // namespace

bool RoundedPolygon::isSound(std::span<const ProfilePoint> corners, double radius) {
  return !corners.empty() && corners.size() <= kMostCorners && std::isfinite(radius) && radius >= 0.0 &&
         std::all_of(corners.begin(), corners.end(), [](const ProfilePoint& p) { return p.allFinite(); });
}

RoundedPolygon::RoundedPolygon(std::span<const ProfilePoint> corners, double radius) : m_radius(radius) {
  assert(isSound(corners, radius));
  std::array<ProfilePoint, kMostCorners> sorted{};
  std::copy(corners.begin(), corners.end(), sorted.begin());
  const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(corners.size());
  std::sort(sorted.begin(), end, isLower);
  const auto last = std::unique(sorted.begin(), end);
  std::array<ProfilePoint, kMostCorners + 1> hull{};
  m_count = hullOf({sorted.begin(), last}, hull);
  std::copy_n(hull.begin(), m_count, m_corners.begin());
}

RoundedPolygon RoundedPolygon::moved(const ProfilePoint& by) const {
  RoundedPolygon result = *this;
  for (std::size_t i = 0; i < m_count; ++i) result.m_corners[i] += by;
  return result;
}

RoundedPolygon RoundedPolygon::mirrored() const {
  RoundedPolygon result = *this;
  for (std::size_t i = 0; i < m_count; ++i) {
    const ProfilePoint& p = m_corners[m_count - 1 - i];
    result.m_corners[i] = {-p.x(), p.y()};
  }
  return result;
}

std::vector<ProfilePoint> RoundedPolygon::outline(int perCircle) const {
  std::vector<ProfilePoint> line;
  if (m_radius == 0.0) line.assign(m_corners.begin(), m_corners.begin() + static_cast<std::ptrdiff_t>(m_count));
  // Each direction belongs to the corner that is furthest in it. z is the first axis of the angle.
  for (int i = 0; m_radius > 0.0 && i < perCircle; ++i) {
    const double angle = 2.0 * M_PI * i / perCircle;
    const ProfilePoint direction(std::sin(angle), std::cos(angle));
    const auto furthest = std::max_element(
        corners().begin(), corners().end(),
        [&](const ProfilePoint& a, const ProfilePoint& b) { return a.dot(direction) < b.dot(direction); });
    if (furthest != corners().end()) line.push_back(*furthest + m_radius * direction);
  }
  if (!line.empty()) line.push_back(line.front());
  return line;
}

bool RoundedPolygon::operator==(const RoundedPolygon& other) const {
  return m_radius == other.m_radius &&
         std::equal(corners().begin(), corners().end(), other.corners().begin(), other.corners().end());
}

SectionSweep::SectionSweep(const RoundedPolygon& section, const ProfilePoint& from, const ProfilePoint& to)
    : m_radius(section.radius()) {
  if (section.empty() || !from.allFinite() || !to.allFinite()) return;
  std::array<ProfilePoint, 2 * RoundedPolygon::kMostCorners> points;
  points.fill(ProfilePoint::Zero());
  std::size_t count = 0;
  for (const ProfilePoint& p : section.corners()) {
    points[count++] = p + from;
    points[count++] = p + to;
  }
  std::sort(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count), isLower);
  for (std::size_t i = 0; i < count; ++i) {
    m_lower.add(points[i]);
    m_upper.add({-points[i].x(), points[i].y()});
  }
  m_first = points[0].y() - m_radius;
  m_last = points[count - 1].y() + m_radius;
  const auto [least, largest] =
      std::minmax_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count),
                          [](const ProfilePoint& a, const ProfilePoint& b) { return a.x() < b.x(); });
  m_least = least->x() - m_radius;
  m_largest = largest->x() + m_radius;
}

// Adds to the lower hull. Points come in the order of z; of those at one z the lowest counts.
void SectionSweep::Chain::add(const ProfilePoint& p) {
  if (count > 0 && points[count - 1].y() == p.y()) {
    if (p.x() >= points[count - 1].x()) return;
    --count;
  }
  while (count >= 2 && turn(points[count - 2], points[count - 1], p) <= 0.0) --count;
  points[count++] = p;
}

// The lowest point is on the disc of a corner, or on an edge moved outward by the radius.
double SectionSweep::Chain::at(double z, double radius) const {
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    const ProfilePoint& p = points[i];
    const double under = radius * radius - (z - p.y()) * (z - p.y());
    if (under >= 0.0) lowest = std::min(lowest, p.x() - std::sqrt(under));
    if (i + 1 == count) break;
    const ProfilePoint along = points[i + 1] - p;
    const double length = along.norm();
    const double t = (z - p.y() - radius * along.x() / length) / along.y();
    if (t >= 0.0 && t <= 1.0) lowest = std::min(lowest, p.x() - radius * along.y() / length + t * along.x());
  }
  return lowest;
}

}  // namespace handwheel
