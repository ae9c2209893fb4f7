// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/KrlStatus.h"

#include "robot/posts/ControllerConfiguration.h"

#include <cmath>

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
  const WantedWay way{
      [&](Eigen::Index i, double value) { return !wanted.turn || isOnSide(value, (*wanted.turn >> i & 1u) != 0); },
      [&](const ArmValues& values) { return !wanted.status || hasStatus(*wanted.status, arm, values); }};
  return jointsOfWay(way, arm, closed, tip, reference);
}

}  // namespace handwheel
