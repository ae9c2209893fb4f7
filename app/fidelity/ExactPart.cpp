// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fidelity/ExactPart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace handwheel {
namespace {

using Vec2 = Eigen::Vector2d;
using Polygon = std::vector<Vec2>;  // counter-clockwise

double distanceToSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}

// Below zero inside: there, the number of sides to the right of the point is odd.
double signedDistance(const Polygon& polygon, const Vec2& p) {
  double distance = std::numeric_limits<double>::infinity();
  bool isInside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    distance = std::min(distance, distanceToSegment(p, a, b));
    const bool isCrossed = (a.y() > p.y()) != (b.y() > p.y());
    if (isCrossed && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) isInside = !isInside;
  }
  return isInside ? -distance : distance;
}

double distanceToCorner(const Polygon& polygon, const Vec2& p) {
  double distance = std::numeric_limits<double>::infinity();
  for (const Vec2& corner : polygon) distance = std::min(distance, (p - corner).norm());
  return distance;
}

double areaOf(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

// Pappus: the area times the path of its centre.
double volumeTurned(const Polygon& polygon) {
  double sixfold = 0.0;  // six times the first moment
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    sixfold += (a.x() + b.x()) * (a.x() * b.y() - a.y() * b.x());
  }
  return 2.0 * std::numbers::pi * sixfold / 6.0;
}

// Combines a distance in the plane and one across it, as for a prism: the exact distance from its surface.
double prismDistance(double inPlane, double across) {
  if (inPlane < 0.0 && across < 0.0) return std::max(inPlane, across);
  return std::hypot(std::max(inPlane, 0.0), std::max(across, 0.0));
}

}  // namespace

ExactPart milledPart() {
  constexpr double kHalf = 25.0;
  static const Polygon outline{{0, 0}, {90, 0}, {90, 30}, {80, 40}, {55, 40}, {45, 70}, {0, 70}};
  const auto across = [](const Vec3& p) { return std::abs(p.z()) - kHalf; };
  ExactPart part;
  part.box = Box(Vec3(0, 0, -kHalf), Vec3(90, 70, kHalf));
  part.distance = [across](const Vec3& p) { return prismDistance(signedDistance(outline, p.head<2>()), across(p)); };
  part.distanceToCrease = [across](const Vec3& p) {
    const Vec2 flat = p.head<2>();
    return std::min(std::hypot(signedDistance(outline, flat), across(p)),
                    std::hypot(distanceToCorner(outline, flat), std::max(across(p), 0.0)));
  };
  part.volume = 2.0 * kHalf * areaOf(outline);
  return part;
}

ExactPart turnedPart() {
  // Radius and height. The side on the axis is none of the surface.
  static const Polygon profile{{0, 0}, {36, 0}, {40, 4}, {40, 20}, {22, 20}, {22, 64}, {16, 70}, {0, 70}};
  static const auto inPlane = [](const Vec3& p) { return Vec2(std::hypot(p.x(), p.y()), p.z()); };
  // Mirrored at the axis, that side is inside, and no nearest point.
  static const Polygon whole = [] {
    Polygon both(profile.begin() + 1, profile.end() - 1);
    for (std::size_t i = profile.size() - 1; i-- > 1;) both.emplace_back(-profile[i].x(), profile[i].y());
    return both;
  }();
  ExactPart part;
  part.box = Box(Vec3(-40, -40, 0), Vec3(40, 40, 70));
  part.distance = [](const Vec3& p) { return signedDistance(whole, inPlane(p)); };
  part.distanceToCrease = [](const Vec3& p) { return distanceToCorner(whole, inPlane(p)); };
  part.volume = volumeTurned(profile);
  return part;
}

}  // namespace handwheel
