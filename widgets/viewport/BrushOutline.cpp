// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/BrushOutline.h"

#include <cmath>
#include <numbers>

namespace handwheel {

namespace {

constexpr int kPoints = 64;

}  // namespace

std::vector<Vec3> brushOutline(const Pickable& pickable, const BrushCircle& brush, const Vec3& towards) {
  Vec3 normal = pickable.mesh ? pickable.mesh->normalNear(brush.centre) : Vec3(Vec3::Zero());
  const bool isOnSurface = normal.squaredNorm() > 0;
  if (!isOnSurface) normal = towards;
  const Vec3 right = normal.unitOrthogonal(), up = normal.cross(right);
  std::vector<Vec3> points;
  for (int i = 0; i <= kPoints; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kPoints;
    const Vec3 p = brush.centre + brush.radius * (std::cos(angle) * right + std::sin(angle) * up);
    const auto hit = isOnSurface ? firstSurface(pickable, p + brush.radius * normal, -normal) : std::nullopt;
    points.push_back(hit && hit->distance <= 2.0 * brush.radius ? hit->point : p);
  }
  return points;
}

}  // namespace handwheel
