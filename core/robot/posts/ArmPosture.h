// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/SerialArm.h"

namespace handwheel {

// Which of its ways an arm with a spherical wrist reaches a pose by, as controllers tell them apart.
struct ArmPosture {
  bool isRear = false;       // the wrist is behind the first axis, seen from how the arm looks with all joints at 0
  bool isElbowDown = false;  // the wrist is behind the lower arm
  bool isFlipped = false;    // the fifth joint is below 0
};

// Six hinges.
ArmPosture postureOf(const SerialArm& arm, const ArmValues& values);

}  // namespace handwheel
