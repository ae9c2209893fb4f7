// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/SerialArm.h"

#include <functional>
#include <optional>

namespace handwheel {

class ClosedFormIk;

// The configuration of an arm with a spherical wrist, as controllers denote it. It says in which of its ways the arm
// reaches a pose.
struct ControllerConfiguration {
  bool isRear = false;       // the wrist is behind the first axis, seen from how the arm looks with all joints at 0
  bool isElbowDown = false;  // the wrist is behind the lower arm
  bool isFlipped = false;    // the fifth joint is below 0
};

// Six hinges.
ControllerConfiguration controllerConfigurationOf(const SerialArm& arm, const ArmValues& values);

// What the joint values of a way must be like.
struct WantedWay {
  std::function<bool(Eigen::Index, double)> takesJoint;  // the value of a joint, counted with its whole turns; rad
  std::function<bool(const ArmValues&)> takes;           // all of them together
};

// The joint values that are wanted, within the limits, which bring the tip of the arm there; the nearest to the
// reference where they leave a choice. None: there are none. closed: that of the arm.
std::optional<ArmValues> jointsOfWay(const WantedWay& wanted, const SerialArm& arm, const ClosedFormIk& closed,
                                     const Pose& tip, const ArmValues& reference);

}  // namespace handwheel
