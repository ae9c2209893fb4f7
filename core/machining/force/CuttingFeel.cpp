// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/CuttingFeel.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kMostSwungForce = 1e7;   // N
constexpr double kFastestHand = 5'000.0;  // mm/s

// Not-a-number becomes the least value.
double withinFeel(double value, double least, double largest) noexcept {
  return value > least ? std::min(value, largest) : least;
}

// A factor that is 1 at no wear and has these values at 0.1 and 0.3 mm.
double wearFactor(double wear, double atTenth, double atThree) noexcept {
  if (wear <= 0.1) return 1.0 + (atTenth - 1.0) * wear / 0.1;
  return atTenth + (atThree - atTenth) * (wear - 0.1) / 0.2;
}

}  // namespace

CutForces worn(const CutForces& sharp, double wear) noexcept {
  const double vb = withinFeel(wear, 0.0, CuttingFeel::kMostWear);
  return {sharp.cutting * wearFactor(vb, 1.19, 1.52), sharp.feed * wearFactor(vb, 1.33, 2.88),
          sharp.radial * wearFactor(vb, 1.59, 3.35), sharp.isCouple};
}

double vibration(const CuttingFeel& feel, double force, double angle, double spindle, double period) noexcept {
  const double turnsPerTick = std::abs(spindle) / 60.0 * period;
  const double heard = withinFeel(2.0 - 8.0 * turnsPerTick, 0.0, 1.0);
  const double share = withinFeel(feel.vibration, 0.0, CuttingFeel::kMostVibration);
  const double swing = std::min(share * withinFeel(force, 0.0, kMostSwungForce),
                                withinFeel(feel.largestSwing, 0.0, CuttingFeel::kMostSwing));
  const double phase = std::isfinite(angle) ? std::sin(angle) : 0.0;
  return heard * swing * phase;
}

double slideResistance(const CuttingFeel& feel, double speed) noexcept {
  if (std::isnan(speed)) return 0.0;
  const double creep = withinFeel(feel.creep, CuttingFeel::kLeastCreep, kFastestHand);
  const double slip = std::clamp(speed / creep, -1.0, 1.0);
  return withinFeel(feel.friction, 0.0, CuttingFeel::kMostFriction) * slip +
         withinFeel(feel.drag, 0.0, CuttingFeel::kMostDrag) * std::clamp(speed, -kFastestHand, kFastestHand);
}

double steepestDamping(const CuttingFeel& feel) noexcept {
  const double creep = withinFeel(feel.creep, CuttingFeel::kLeastCreep, kFastestHand);
  return withinFeel(feel.friction, 0.0, CuttingFeel::kMostFriction) / creep +
         withinFeel(feel.drag, 0.0, CuttingFeel::kMostDrag);
}

}  // namespace handwheel
