// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/SerialArm.h"

namespace handwheel {

// The configuration of an arm with a spherical wrist, as controllers denote it. It says in which of its ways the arm
// reaches a pose.
struct ControllerConfiguration {
  bool isRear = false;       // the wrist is behind the first axis, seen from how the arm looks with all joints at 0
  bool isElbowDown = false;  // the wrist is behind the lower arm
  bool isFlipped = false;    // the fifth joint is below 0
};

// Six hinges.
ControllerConfiguration controllerConfigurationOf(const SerialArm& arm, const ArmValues& values);

}  // namespace handwheel
