// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/scene/PlacingHandles.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr int kRingPieces = 64;
constexpr double kGrip = 0.15;      // Share of an arrow from its centre, where the arrows cannot be distinguished
constexpr double kArrowHead = 0.1;  // Share of an arrow
constexpr int kArrowPieces = 24;    // Number of tested pieces of an arrow

}  // namespace

std::array<PlacingHandles::Handle, 6> PlacingHandles::all() const {
  return {Handle{0, false}, {1, false}, {2, false}, {0, true}, {1, true}, {2, true}};
}

// Points along a handle.
std::vector<Vec3> PlacingHandles::outlineOf(const Handle& handle) const {
  const auto axis = static_cast<std::size_t>(handle.axis);
  std::vector<Vec3> points;
  if (!handle.isRing) {
    for (int i = 0; i <= kArrowPieces; ++i)
      points.push_back(centre + (kGrip + (1.0 - kGrip) * i / kArrowPieces) * length * axes[axis]);
    return points;
  }
  const Vec3 &u = axes[(axis + 1) % 3], &v = axes[(axis + 2) % 3];
  for (int i = 0; i <= kRingPieces; ++i) {
    const double angle = 2.0 * M_PI * i / kRingPieces;
    points.push_back(centre + ringRadius() * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return points;
}

std::optional<PlacingHandles::Handle> PlacingHandles::under(const PickRay& pickRay, double pixels) const {
  std::optional<Handle> found;
  double nearest = std::numeric_limits<double>::infinity();
  const Ray& ray = pickRay.ray;
  for (const Handle& handle : all()) {
    const std::vector<Vec3> points = outlineOf(handle);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vec3 middle = 0.5 * (points[i - 1] + points[i]);
      const double along = (middle - ray.origin).dot(ray.direction);
      const double aside = (middle - ray.origin - along * ray.direction).norm();
      const double reach = pixels * pickRay.pixelAt(middle) + 0.5 * (points[i] - points[i - 1]).norm();
      const bool isBehindArrow = handle.isRing && found && !found->isRing;  // arrows come first
      if (!(aside <= reach) || (pickRay.eye && along <= 0.0) || along >= nearest || isBehindArrow) continue;
      nearest = along;
      found = handle;
    }
  }
  return found;
}

std::optional<PlacingHandles::Handle> PlacingHandles::near(const Vec3& position, double distance) const {
  std::optional<Handle> found;
  double nearest = distance;
  for (const Handle& handle : all()) {
    for (const Vec3& point : outlineOf(handle)) {
      const double apart = (point - position).norm();
      if (apart > nearest) continue;
      nearest = apart;
      found = handle;
    }
  }
  return found;
}

std::vector<std::vector<Vec3>> PlacingHandles::linesOf(const Handle& handle) const {
  if (handle.isRing) return {outlineOf(handle)};
  const auto axis = static_cast<std::size_t>(handle.axis);
  const Vec3 end = centre + length * axes[axis], back = end - kArrowHead * length * axes[axis];
  const Vec3 aside = 0.4 * kArrowHead * length * axes[(axis + 1) % 3];
  return {{centre, end}, {back + aside, end, back - aside}};
}

}  // namespace handwheel
