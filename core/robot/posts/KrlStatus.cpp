// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/KrlStatus.h"

#include "robot/posts/ControllerConfiguration.h"

#include <cmath>

namespace handwheel {

namespace {

std::string bits(unsigned value, unsigned count) {
  std::string text = "'B";
  for (unsigned i = count; i-- > 0;) text += (value >> i & 1u) != 0 ? '1' : '0';
  return text + "'";
}

// off: tolerance of the value; rad.
bool isOnSide(double value, bool isBelow, double off) {
  return std::abs(value) < off || (value < 0.0) == isBelow;
}

bool hasStatus(unsigned wanted, const SerialArm& arm, const ArmValues& values) {
  const unsigned different = wanted ^ *krlStatusOf(arm, values).status;
  return (different & 3u) == 0 && (((different & 4u) == 0) || isWristInLine(values));
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
  const auto isBelow = [&](Eigen::Index i) { return (wanted.turn.value_or(0) >> i & 1u) != 0; };
  const WantedConfiguration conditions{
      [&](Eigen::Index i, double value, double off) { return !wanted.turn || isOnSide(value, isBelow(i), off); },
      [&](const ArmValues& values) { return !wanted.status || hasStatus(*wanted.status, arm, values); }};
  if (!wanted.turn) return jointsOfConfiguration(conditions, arm, closed, tip, std::array{reference});
  // If two axes are in line, the solution has the first from the reference. It is 0, or half a turn to its side: at one
  // of these the other axis is within its own half.
  ArmValues nearest = reference, none = reference, half = reference;
  for (const Eigen::Index i : {Eigen::Index{0}, Eigen::Index{3}}) {
    const double side = isBelow(i) ? -1.0 : 1.0;
    nearest[i] = side * std::max(0.0, side * reference[i]);
    none[i] = 0.0;
    half[i] = side * M_PI;
  }
  return jointsOfConfiguration(conditions, arm, closed, tip, std::array{nearest, none, half});
}

}  // namespace handwheel
