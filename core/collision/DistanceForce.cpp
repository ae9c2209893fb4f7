// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/DistanceForce.h"

#include <algorithm>

namespace handwheel {

DistanceWrench distanceForce(std::span<const NearPair> near, const Vec3& reference,
                             const DistanceForceSettings& settings) {
  DistanceWrench sum;
  for (const NearPair& pair : near) {
    const ClosestPoints& points = pair.points;
    const double nearer = settings.reach - points.distance;
    if (!(nearer > 0.0) || !points.normal.allFinite() || !points.first.allFinite()) continue;
    // Beyond the deepest penetration the force is constant, and its energy grows linearly.
    const double most = settings.reach + settings.deepest, counted = std::min(nearer, most);
    const Vec3 force = settings.stiffness * counted * points.normal;
    sum.force += force;
    sum.torque += settings.torqueShare * (points.first - reference).cross(force);
    sum.energy += settings.stiffness * counted * (nearer - 0.5 * counted);
  }
  const double size = sum.force.norm();
  if (size > settings.largestForce) {
    const double share = settings.largestForce / size;
    sum.force *= share;
    sum.torque *= share;
  }
  return sum;
}

}  // namespace handwheel
