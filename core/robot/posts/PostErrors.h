// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The error codes of programs for controllers.
namespace handwheel::PostError {

extern const ErrorDescription WrongJoints;           // {language, wanted, count}: the arm has another number of joints
extern const ErrorDescription NoSlides;              // {language, joint}: the joint is prismatic
extern const ErrorDescription TooManyMotions;        // {count, most}: numbers of motions
extern const ErrorDescription NotFinite;             // {motion}: a value is not a number
extern const ErrorDescription StatementUnread;       // {beginning of a statement that may change the motion}
extern const ErrorDescription TooFast;               // {motion, mm/s, language, most mm/s}: the line is too fast
extern const ErrorDescription BaseUnknown;           // {robot}: the base of its controller is not known
extern const ErrorDescription ConfigurationDiffers;  // {configuration}: the arm ends the line in another one
extern const ErrorDescription PoseUnreached;         // a joint motion to a pose that the arm does not reach so
extern const ErrorDescription DataElsewhere;         // tool or frame of a pose are on the controller
extern const ErrorDescription FunctionUnread;        // {name}: a function in place of a target
extern const ErrorDescription LinesOfOther;          // {first line, language, language of it, numbers of all}
extern const ErrorDescription NoCorners;             // {motion, language}: it has no CNT
extern const ErrorDescription LinkageUnknown;        // {robot, language}: the coupling of its axes 2 and 3 is unknown
extern const ErrorDescription ThirdBeyond;           // {motion, degrees, lower, upper}: axis 3 as the controller has it
extern const ErrorDescription TurnsTooFar;           // {joint, degrees}: a joint without limits, by over half a turn
extern const ErrorDescription MotionDiffers;         // {motion, what, wanted, read}

}  // namespace handwheel::PostError
