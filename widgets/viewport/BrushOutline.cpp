// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/BrushOutline.h"

#include <cmath>
#include <numbers>

namespace handwheel {

namespace {

constexpr int kPoints = 64;
constexpr double kLeap = 0.5;  // share of the radius, from a point to the next: not along one surface

}  // namespace

std::vector<Vec3> brushOutline(const Pickable& pickable, const BrushCircle& brush, const Vec3& towards) {
  Vec3 normal = Vec3::Zero();
  for (const ViewLayer* layer : pickable.layers) {
    if (normal.squaredNorm() == 0) normal = layer->normalNear(brush.centre);
  }
  const bool isOnSurface = normal.squaredNorm() > 0;
  if (!isOnSurface) normal = towards;
  const Vec3 right = normal.unitOrthogonal(), up = normal.cross(right);
  std::vector<Vec3> flat, laid;
  bool leaps = false;
  for (int i = 0; i <= kPoints; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kPoints;
    const Vec3 p = brush.centre + brush.radius * (std::cos(angle) * right + std::sin(angle) * up);
    const Pick hit = isOnSurface ? pickAlong(pickable, p + brush.radius * normal, -normal) : Pick{};
    flat.push_back(p);
    laid.push_back(!hit.isNothing() && hit.distance <= 2.0 * brush.radius ? hit.point : p);
    leaps = leaps || (i > 0 && (laid[laid.size() - 2] - laid.back()).norm() > kLeap * brush.radius);
  }
  return leaps ? flat : laid;
}

}  // namespace handwheel
