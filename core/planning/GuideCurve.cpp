// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/GuideCurve.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kEnd = 0.01;      // of the length: so near to an end it is the end
constexpr double kAhead = 0.1;     // of the length: no further in one step
constexpr double kBeginning = 20;  // mm: who is nearer to the begin than this, or a tenth of the length, has begun

}  // namespace

GuideCurve::GuideCurve(std::span<const Vec3> points) {
  for (const Vec3& point : points) {
    if (!point.allFinite() || (!m_points.empty() && point == m_points.back())) continue;
    m_along.push_back(m_points.empty() ? 0.0 : m_along.back() + (point - m_points.back()).norm());
    m_points.push_back(point);
  }
}

GuideCurve::Nearest GuideCurve::nearest(const Vec3& to, double from, double until) const {
  Nearest best;
  if (!to.allFinite()) return best;
  for (std::size_t i = 0; i < m_points.size(); ++i) {
    const bool isLast = i + 1 == m_points.size();
    if (isLast && i > 0) break;
    const double length = isLast ? 0.0 : m_along[i + 1] - m_along[i];
    if (m_along[i] + length < from || m_along[i] > until) continue;
    const Vec3 way = isLast ? Vec3::Zero() : Vec3((m_points[i + 1] - m_points[i]) / length);
    const double least = std::clamp(from - m_along[i], 0.0, length);
    const double along = std::clamp(way.dot(to - m_points[i]), least, std::clamp(until - m_along[i], least, length));
    const Vec3 place = m_points[i] + along * way;
    const double distance = (to - place).norm();
    if (distance < best.distance) best = {place, distance, m_along[i] + along};
  }
  return best;
}

Vec3 GuideCurve::drawn(const Vec3& place, double snapDistance) const {
  const Nearest near = nearest(place);
  if (!(near.distance < snapDistance)) return place;
  const double share = near.distance / snapDistance;
  return near.place + share * share * (place - near.place);
}

void FollowingTry::add(double time, const Vec3& place) {
  const double length = m_curve.length();
  if (m_isOver || !(length > 0.0) || !place.allFinite() || !std::isfinite(time)) return;
  if (!hasBegun()) {
    m_deviation = (place - m_curve.points().front()).norm();
    if (m_deviation > std::min(kBeginning, kAhead * length)) return;
    m_begin = m_time = time;
  }
  const GuideCurve::Nearest near =
      m_curve.nearest(place, std::max(0.0, m_along - kAhead * length), m_along + kAhead * length);
  // Over the time since the last place; between the two the deviation changes evenly.
  const double seconds = std::max(0.0, time - m_time);
  if (seconds > 0.0) {
    const double a = m_deviation, b = near.distance;
    m_squares += seconds * (a * a + a * b + b * b) / 3.0;
  }
  m_time = std::max(m_time, time);
  m_deviation = near.distance;
  m_most = std::max(m_most, near.distance);
  m_along = std::max(m_along, near.along);
  m_isOver = m_along >= (1.0 - kEnd) * length;
}

FollowingStatistics FollowingTry::figures() const {
  FollowingStatistics figures;
  if (!hasBegun()) return figures;
  figures.seconds = m_time - m_begin;
  figures.rms = figures.seconds > 0.0 ? std::sqrt(m_squares / figures.seconds) : m_deviation;
  figures.most = m_most;
  figures.share = m_isOver ? 1.0 : m_along / m_curve.length();
  return figures;
}

}  // namespace handwheel
