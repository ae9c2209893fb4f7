// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/NumericalIk.h"

namespace handwheel {

// The two inverse kinematics of He 2008, for comparison with solvedNumerically(). They iterate from the given start
// alone, undamped, and ignore limits and singularities. Of the settings they use only tolerance and length.
// O(iterations · joints²).

// Solves by IK1 (He 2008, equation 6-8): δq = J⁺ δX, where δX is the missing displacement and rotation.
NumericalIkResult solvedByJacobian(const SerialArm& arm, const Pose& tip, const ArmValues& start,
                                   const NumericalIkSettings& settings = {});

// Solves by IK2 (He 2008, equations 6-10 and 6-11): δq = (∂T/∂q)⁺ (T' - T), the Taylor expansion of the twelve numbers
// of the pose T.
NumericalIkResult solvedByTaylor(const SerialArm& arm, const Pose& tip, const ArmValues& start,
                                 const NumericalIkSettings& settings = {});

}  // namespace handwheel
