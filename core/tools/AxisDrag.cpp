// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/AxisDrag.h"

#include "base/Tolerance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handwheel {

namespace {

constexpr double kEdgeOn = 0.2;       // sine of the angle below which a circle is seen from the side
constexpr double kLongestStep = 0.3;  // rad
constexpr double kShortestStep = 1e-9;
constexpr int kSteps = 30;

// The held point on its circle.
class Circle {
 public:
  explicit Circle(const HeldPoint& held) : m_axis(held.axis) {
    const Vec3 arm = held.point - held.centre;
    m_radial = arm - arm.dot(m_axis) * m_axis;
    m_middle = held.point - m_radial;
    m_across = m_axis.cross(m_radial);
  }

  // Returns the angle of a point around the axis; none at the middle.
  std::optional<double> angleOf(const Vec3& inPlane) const {
    const Vec3 arm = inPlane - m_middle;
    const double x = arm.dot(m_radial), y = arm.dot(m_across);
    if (!std::isfinite(x) || !std::isfinite(y) || std::hypot(x, y) < tolerance::kParallelLines * m_radial.squaredNorm())
      return {};
    return std::atan2(y, x);
  }

  double distanceAt(double angle, const Ray& ray) const { return aside(pointAt(angle) - ray.origin, ray).norm(); }

  // Moves towards the ray by Gauss-Newton steps, halved until they reduce the distance.
  double nearest(double angle, const Ray& ray) const {
    for (int i = 0; i < kSteps; ++i) {
      const Vec3 off = aside(pointAt(angle) - ray.origin, ray);
      const Vec3 toRay = aside(std::cos(angle) * m_across - std::sin(angle) * m_radial, ray);
      const double stiffness = toRay.squaredNorm() + 1e-9 * m_radial.squaredNorm();
      double step = std::clamp(-toRay.dot(off) / stiffness, -kLongestStep, kLongestStep);
      while (std::abs(step) > kShortestStep && !(distanceAt(angle + step, ray) < off.norm())) step *= 0.5;
      if (!(std::abs(step) > kShortestStep)) break;
      angle += step;
    }
    return angle;
  }

 private:
  Vec3 pointAt(double angle) const { return m_middle + std::cos(angle) * m_radial + std::sin(angle) * m_across; }
  static Vec3 aside(const Vec3& v, const Ray& ray) { return v - v.dot(ray.direction) * ray.direction; }

  Vec3 m_axis, m_middle, m_radial, m_across;
};

}  // namespace

std::optional<double> rotationUnder(const HeldPoint& held, const PickRay& pickRay, double soFar) {
  const Ray& ray = pickRay.ray;
  const Circle circle(held);
  const double slope = ray.direction.dot(held.axis);
  if (std::abs(slope) >= kEdgeOn) {
    const double along = (held.point - ray.origin).dot(held.axis) / slope;
    if (pickRay.eye && along <= 0.0) return {};
    const auto angle = circle.angleOf(ray.origin + along * ray.direction);
    if (!angle) return {};
    return soFar + std::remainder(*angle - soFar, 2.0 * std::numbers::pi);
  }
  // At the rim the point moves along the ray, and only another start finds the solution.
  double best = soFar, distance = circle.distanceAt(soFar, ray);
  for (double start : {soFar, soFar - kLongestStep, soFar + kLongestStep}) {
    const double angle = circle.nearest(start, ray);
    const double reached = circle.distanceAt(angle, ray);
    if (!(reached < distance * (1.0 - 1e-6))) continue;
    best = angle;
    distance = reached;
  }
  return best;
}

std::optional<double> translationUnder(const HeldPoint& held, const Ray& ray) {
  const double together = held.axis.dot(ray.direction);
  const double square = 1.0 - together * together;
  if (square < tolerance::kParallelLines * tolerance::kParallelLines) return {};
  const Vec3 between = held.point - ray.origin;
  const double travel = (together * ray.direction.dot(between) - held.axis.dot(between)) / square;
  return std::isfinite(travel) ? std::optional(travel) : std::nullopt;
}

std::optional<Vec3> positionUnder(const Vec3& point, const Vec3& facing, const Ray& ray) {
  const double slope = ray.direction.dot(facing);
  if (std::abs(slope) < tolerance::kParallelLines) return {};
  const Vec3 position = ray.origin + (point - ray.origin).dot(facing) / slope * ray.direction;
  return position.allFinite() ? std::optional(position) : std::nullopt;
}

}  // namespace handwheel
