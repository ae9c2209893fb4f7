// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/ConeProjection.h"

#include "base/Tolerance.h"

#include <cmath>
#include <limits>
#include <optional>

namespace handwheel {
namespace {

using tolerance::kOnePlane, tolerance::kSpannedVolume;

// Returns the point to which planes with these multipliers push the goal; none when a plane would have to pull.
std::optional<Vec3> onPlane(const Vec3& goal, const HalfSpace& a) {
  const double push = a.least - a.normal.dot(goal);
  if (push < 0.0) return std::nullopt;
  return goal + push * a.normal;
}

std::optional<Vec3> onLine(const Vec3& goal, const HalfSpace& a, const HalfSpace& b) {
  const double cosine = a.normal.dot(b.normal);
  // The cross product is used because 1 - cosine² would lose the small angles.
  const double determinant = a.normal.cross(b.normal).squaredNorm();
  if (determinant < kOnePlane) return std::nullopt;
  const double pushA = a.least - a.normal.dot(goal);
  const double pushB = b.least - b.normal.dot(goal);
  const double alongA = (pushA - cosine * pushB) / determinant;
  const double alongB = (pushB - cosine * pushA) / determinant;
  if (alongA < 0.0 || alongB < 0.0) return std::nullopt;
  return goal + alongA * a.normal + alongB * b.normal;
}

std::optional<Vec3> onCorner(const Vec3& goal, const HalfSpace& a, const HalfSpace& b, const HalfSpace& c) {
  const Vec3 bc = b.normal.cross(c.normal), ca = c.normal.cross(a.normal), ab = a.normal.cross(b.normal);
  const double volume = a.normal.dot(bc);
  if (volume * volume < kSpannedVolume) return std::nullopt;
  const Vec3 corner = (a.least * bc + b.least * ca + c.least * ab) / volume;
  // The multipliers: goal + Σ λ n = corner.
  const Vec3 push = corner - goal;
  if (push.dot(bc) / volume < 0.0 || push.dot(ca) / volume < 0.0 || push.dot(ab) / volume < 0.0) return std::nullopt;
  return corner;
}

class Search {
 public:
  Search(std::span<const HalfSpace> planes, double slack) : m_planes(planes), m_slack(slack) {}

  // Returns true once a point fits.
  bool offer(const std::optional<Vec3>& y) {
    if (!y) return false;
    double missed = 0.0;
    for (const HalfSpace& plane : m_planes) missed = std::max(missed, plane.least - plane.normal.dot(*y));
    if (missed < m_missed) {
      m_missed = missed;
      m_best = *y;
    }
    return missed <= m_slack;
  }
  const Vec3& best() const { return m_best; }

 private:
  std::span<const HalfSpace> m_planes;
  double m_slack;
  double m_missed = std::numeric_limits<double>::infinity();
  Vec3 m_best = Vec3::Zero();
};

}  // namespace

Vec3 nearestInCone(const Vec3& goal, std::span<const HalfSpace> planes, double slack) {
  Search search(planes, slack);
  if (search.offer(goal)) return goal;
  for (const HalfSpace& a : planes)
    if (search.offer(onPlane(goal, a))) return search.best();
  const std::size_t n = planes.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      if (search.offer(onLine(goal, planes[i], planes[j]))) return search.best();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k)
        if (search.offer(onCorner(goal, planes[i], planes[j], planes[k]))) return search.best();
  return search.best();
}

}  // namespace handwheel
