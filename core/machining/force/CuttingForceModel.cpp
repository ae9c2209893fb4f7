// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/CuttingForceModel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handwheel {

double CutForces::norm() const {
  return std::hypot(isCouple ? 0.0 : cutting, feed, radial);
}

CutForces CuttingForceModel::onDrill(const CutConditions& cut) const noexcept {
  return drillForces(at({cut.depth, 0.5 * cut.feed, cut.speed}).cutting);
}

CutForces drillForces(double lip) noexcept {
  return {2.0 * lip, lip * std::sin(kDrillPoint), 0.0, true};
}

CutConditions bounded(const CutConditions& cut) noexcept {
  // Written so that NaN fails each test.
  if (!(cut.depth > 0.0) || !(cut.feed > 0.0) || !(cut.speed >= 0.0)) return {};
  return {std::min(cut.depth, kMostDepth), std::min(cut.feed, kMostFeed),
          std::clamp(cut.speed, kLeastSpeed, kLargestSpeed)};
}

double cuttingPower(const CutForces& forces, const CutConditions& cut) noexcept {
  return forces.cutting * cut.speed / 60'000.0;
}

double cuttingTorque(const CutForces& forces, double diameter) noexcept {
  return forces.cutting * 0.5 * diameter / 1'000.0;
}

double motorPower(double cuttingPower, double efficiency) noexcept {
  return cuttingPower / efficiency;
}

double spindleSpeed(double speed, double diameter) noexcept {
  return diameter > 0.0 ? 1'000.0 * speed / (std::numbers::pi * diameter) : 0.0;
}

double surfaceSpeed(double spindle, double diameter) noexcept {
  return std::numbers::pi * diameter * spindle / 1'000.0;
}

}  // namespace handwheel
