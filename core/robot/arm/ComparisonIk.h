// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/NumericalIk.h"

namespace handwheel {

// The two inverse kinematics of He 2008, for comparison with ours. Both iterate from the start alone, undamped, and
// ignore limits and singularities. They use only the settings tolerance and length. O(iterations · joints²).

// IK1 (equation 6-8): δq = J⁺ δX, with the missing displacement and rotation δX.
NumericalIkResult solvedByJacobian(const SerialArm& arm, const Pose& tip, const ArmValues& start,
                                   const NumericalIkSettings& settings = {});

// IK2 (equations 6-10 and 6-11): δq = (∂T/∂q)⁺ (T' - T), by the Taylor expansion of the twelve numbers of the pose T.
NumericalIkResult solvedByTaylor(const SerialArm& arm, const Pose& tip, const ArmValues& start,
                                 const NumericalIkSettings& settings = {});

}  // namespace handwheel
