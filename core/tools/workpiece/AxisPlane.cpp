// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workpiece/AxisPlane.h"

#include <cmath>

namespace handwheel {

std::optional<Vec3> intersectAxisPlane(const Ray& ray) {
  const Vec3 across(ray.direction.x(), ray.direction.y(), 0.0);
  const double facing = across.norm();
  if (!(facing > 1e-3)) return std::nullopt;
  const Vec3 normal = across / facing;
  const double distance = -ray.origin.dot(normal) / ray.direction.dot(normal);
  if (!std::isfinite(distance) || distance < 0.0) return std::nullopt;
  return Vec3(ray.origin + distance * ray.direction);
}

}  // namespace handwheel
