// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The error codes of programs for controllers.
namespace handwheel::PostError {

extern const ErrorDescription WrongJoints;  // {language, wanted, count} the controller moves another number of joints
extern const ErrorDescription NoSlides;     // {language, joint}
extern const ErrorDescription TooManyMotions;   // {count, most}
extern const ErrorDescription NotFinite;        // {motion}
extern const ErrorDescription StatementUnread;  // {statement, line} it may change the motion of the robot
extern const ErrorDescription TooFast;          // {motion, mm/s, language, most mm/s}
extern const ErrorDescription BaseUnknown;      // {robot} the poses of a program are in the base of its controller
extern const ErrorDescription
    ConfigurationDiffers;  // {configuration} of the end of a line in the program, which differs from that of the arm
extern const ErrorDescription MotionDiffers;  // {motion, "kind", "speed" or "blend", wanted, read}

}  // namespace handwheel::PostError
