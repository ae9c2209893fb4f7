// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/KrlStatus.h"

#include "robot/arm/ClosedFormIk.h"
#include "robot/posts/ControllerConfiguration.h"

namespace handwheel {

namespace {

constexpr double kNoSign = 1e-4;  // rad: nearer to 0 an axis may be on either side, as files round

std::string bits(unsigned value, unsigned count) {
  std::string text = "'B";
  for (unsigned i = count; i-- > 0;) text += (value >> i & 1u) != 0 ? '1' : '0';
  return text + "'";
}

bool isOnSide(double value, bool isBelow) {
  return std::abs(value) < kNoSign || (value < 0.0) == isBelow;
}

// Moved by whole turns, within the limits; of those with the sign that is asked for the nearest.
std::optional<double> turnedInto(const ArmJoint& joint, double value, double near, std::optional<bool> isBelow) {
  std::optional<double> nearest;
  for (int turns = -2; turns <= 2; ++turns) {
    const double moved = value + 2.0 * M_PI * turns;
    if (!joint.isWithin(moved) || (isBelow && !isOnSide(moved, *isBelow))) continue;
    if (!nearest || std::abs(moved - near) < std::abs(*nearest - near)) nearest = moved;
  }
  return nearest;
}

bool hasStatus(unsigned wanted, const SerialArm& arm, const ArmValues& values) {
  const unsigned different = wanted ^ *krlStatusOf(arm, values).status;
  return (different & 3u) == 0 && isOnSide(values[4], (wanted & 4u) != 0);
}

}  // namespace

std::string KrlStatus::text() const {
  return "S " + bits(status.value_or(0), 3) + ",T " + bits(turn.value_or(0), 6);
}

KrlStatus krlStatusOf(const SerialArm& arm, const ArmValues& values) {
  const ControllerConfiguration configuration = controllerConfigurationOf(arm, values);
  unsigned turn = 0;
  for (int i = 0; i < 6; ++i) turn |= values[i] < 0.0 ? 1u << i : 0u;
  return {
      (configuration.isRear ? 1u : 0u) | (configuration.isElbowDown ? 0u : 2u) | (configuration.isFlipped ? 4u : 0u),
      turn};
}

std::optional<ArmValues> jointsWith(const KrlStatus& wanted, const SerialArm& arm, const ClosedFormIk& closed,
                                    const Pose& tip, const ArmValues& reference) {
  IkSolutions solutions;
  closed.solve(tip, reference, solutions);
  std::optional<ArmValues> nearest;
  for (const IkSolutions::Solution& solution : solutions) {
    ArmValues values = solution.values;
    bool isWithin = true;
    for (Eigen::Index i = 0; i < values.size() && isWithin; ++i) {
      const auto isBelow = wanted.turn ? std::optional((*wanted.turn >> i & 1u) != 0) : std::nullopt;
      const auto value = turnedInto(arm.joints()[static_cast<std::size_t>(i)], values[i], reference[i], isBelow);
      isWithin = value.has_value();
      values[i] = value.value_or(0.0);
    }
    if (!isWithin || (wanted.status && !hasStatus(*wanted.status, arm, values))) continue;
    if (!nearest || (values - reference).squaredNorm() < (*nearest - reference).squaredNorm()) nearest = values;
  }
  return nearest;
}

}  // namespace handwheel
