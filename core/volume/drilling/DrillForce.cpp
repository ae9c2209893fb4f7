// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillForce.h"

#include <cmath>

namespace handwheel {

DrillLoad drillLoad(const DrillMaterial& material, const DrillBit& tool, double removed, double dt, double feed,
                    double spindle) {
  const double speed = std::abs(feed) + 0.5 * material.tangential * tool.diameter * std::abs(spindle);
  if (!(removed > 0.0) || !(dt > 0.0) || !(speed > 0.0)) return {};
  const double thrust = material.energy * removed / (speed * dt);
  return {thrust, 0.5 * material.tangential * thrust * tool.diameter};
}

DrillLoad referenceLoad(const DrillBit& tool, double strength, double pressure, double feed) {
  if (tool.shape == DrillShape::Saw) return {};
  const double angle = tool.shape == DrillShape::Twist ? tool.pointAngle : M_PI;
  return {strength * feed * 0.5 * tool.diameter * std::sin(0.5 * angle),
          5.0 * pressure * feed * tool.diameter * tool.diameter / 8.0};
}

DrillLoad agreeingReference(const DrillMaterial& material, const DrillBit& tool, double feed, double spindle) {
  const double turns = std::abs(spindle) / (2.0 * M_PI);
  if (!(turns > 0.0)) return {};
  return referenceLoad(tool, material.energy / (2.0 * material.tangential), material.energy / 5.0, feed / turns);
}

double drillVoxel(double feed, double rate, double levels, double step) {
  return levels * feed / (step * rate);
}

}  // namespace handwheel
