// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/GuideCurve.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kEnd = 0.01;   // share of the length: the tolerance at both ends
constexpr double kAhead = 0.1;  // share of the length: the longest progress in one step
constexpr double kBeginning =
    20;  // mm: the curve begins within this distance, or a tenth of the length, of its first point

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
    const Vec3 direction = isLast ? Vec3::Zero() : Vec3((m_points[i + 1] - m_points[i]) / length);
    const double least = std::clamp(from - m_along[i], 0.0, length);
    const double along =
        std::clamp(direction.dot(to - m_points[i]), least, std::clamp(until - m_along[i], least, length));
    const Vec3 position = m_points[i] + along * direction;
    const double distance = (to - position).norm();
    if (distance < best.distance) best = {position, distance, m_along[i] + along};
  }
  return best;
}

Vec3 GuideCurve::drawn(const Vec3& tool, double snapDistance) const {
  const Nearest near = nearest(tool);
  if (!(near.distance < snapDistance)) return tool;
  const double share = near.distance / snapDistance;
  return near.position + share * share * (tool - near.position);
}

void FollowingTry::add(double time, const Vec3& tool) {
  const double length = m_curve.length();
  if (m_isOver || !(length > 0.0) || !tool.allFinite() || !std::isfinite(time)) return;
  if (!hasBegun()) {
    m_deviation = (tool - m_curve.points().front()).norm();
    if (m_deviation > std::min(kBeginning, kAhead * length)) return;
    m_begin = m_time = time;
  }
  const GuideCurve::Nearest near =
      m_curve.nearest(tool, std::max(0.0, m_along - kAhead * length), m_along + kAhead * length);
  // Integrates over the time since the last position; the deviation changes linearly in between.
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
