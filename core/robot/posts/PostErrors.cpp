// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/PostErrors.h"

namespace handwheel {

const ErrorDescription PostError::WrongJoints{
    .id = "PostWrongJoints",
    .sentences = {translatable("ErrorText", "%1 programs move %2 joints, and this arm has %3")},
    .advice = {translatable("ErrorText", "Write the path as CSV or JSON.")}};

const ErrorDescription PostError::NoSlides{
    .id = "PostNoSlides",
    .sentences = {translatable("ErrorText", "joint %2 of the arm is prismatic, which %1 programs do not support")},
    .advice = {translatable("ErrorText", "Write the path as CSV or JSON.")}};

const ErrorDescription PostError::TooManyMotions{
    .id = "PostTooManyMotions",
    .sentences = {translatable("ErrorText", "the path has %1 motions, and a program can have %2")},
    .advice = {translatable("ErrorText", "Divide the path.")}};

const ErrorDescription PostError::NotFinite{
    .id = "PostNotFinite",
    .sentences = {translatable("ErrorText", "motion %1 has a value that is not a number")},
    .advice = {translatable("ErrorText", "Plan the path again.")}};

const ErrorDescription PostError::StatementUnread{
    .id = "PostStatementUnread",
    .sentences = {translatable("ErrorText", "'%1' is not supported, and may change where or whether the robot moves")},
    .advice = {translatable("ErrorText",
                            "In a copy of the program, replace it by the motions that it leads to, or remove it.")}};

const ErrorDescription PostError::TooFast{
    .id = "PostTooFast",
    .sentences = {translatable("ErrorText",
                               "motion %1 is a line at %2 mm/s, and %3 controllers accept at most %4 mm/s")},
    .advice = {translatable("ErrorText", "Lower the speed of the place at its end.")}};

const ErrorDescription PostError::BaseUnknown{
    .id = "PostBaseUnknown",
    .sentences = {translatable("ErrorText",
                               "the pose is in the base of the controller, which the description of %1 does not have")},
    .advice = {translatable(
        "ErrorText",
        "Use the built-in robot, add a link 'base' to the description, or give the motions joint values.")}};

const ErrorDescription PostError::ConfigurationDiffers{
    .id = "PostWayDiffers",
    .sentences = {translatable(
        "ErrorText", "along the line the arm does not come to its end with configuration %1, and controllers stop")},
    .advice = {translatable(
        "ErrorText", "In a copy of the program, correct the configuration, or write ConfL\\Off before the line.")}};

const ErrorDescription PostError::PoseUnreached{
    .id = "PostPoseUnreached",
    .sentences = {translatable("ErrorText",
                               "the robot does not reach this place in the configuration that the program gives")},
    .advice = {translatable("ErrorText",
                            "Check that the program is for this robot, its tool and its frame, or correct the "
                            "configuration in a copy of the program.")}};

const ErrorDescription PostError::DataElsewhere{
    .id = "PostDataElsewhere",
    .sentences = {translatable("ErrorText",
                               "the tool or frame of this place is on the controller, not in the file, or it moves")},
    .advice = {translatable("ErrorText",
                            "Add its data to a copy of the program, or create a frame of that name in the cell.")}};

const ErrorDescription PostError::FunctionUnread{
    .id = "PostFunctionUnread",
    .sentences = {translatable("ErrorText", "the place is the result of the function %1, which is not supported")},
    .advice = {translatable("ErrorText", "In a copy of the program, replace it by the numbers that it returns.")}};

const ErrorDescription PostError::LinesOfOther{
    .id = "PostLinesOfOther",
    .sentences = {translatable("ErrorText", "'%1' is a line of %3, and %2 programs cannot have it (lines: %4)")},
    .advice = {translatable("ErrorText",
                            "Write the program in its own language, or without these lines; on the command line: "
                            "--without-io.")}};

const ErrorDescription PostError::NoCorners{
    .id = "PostNoCorners",
    .sentences = {translatable("ErrorText", "motion %1 ends with the rounding CNT, which %2 programs do not have")},
    .advice = {translatable("ErrorText",
                            "Set the rounding of the place to 0 (FINE), and a blend if need be; on the command line: "
                            "--cnt-as-fine.")}};

const ErrorDescription PostError::LinkageUnknown{
    .id = "PostLinkageUnknown",
    .sentences = {translatable("ErrorText", "the description of %1 lacks its parallel linkage, which %2 counts with")},
    .advice = {translatable("ErrorText", "Use the built-in robot irb2400, or write the path as CSV or JSON.")}};

const ErrorDescription PostError::ThirdBeyond{
    .id = "PostThirdBeyond",
    .sentences = {translatable("ErrorText", "motion %1 ends with axis 3 at %2° from the level, beyond %3° to %4°")},
    .advice = {translatable("ErrorText", "Move joints 2 and 3 at that place, and verify the path again.")}};

const ErrorDescription PostError::TurnsTooFar{
    .id = "PostTurnsTooFar",
    .sentences = {translatable("ErrorText",
                               "the motion turns joint %1 by %2°, and the description of the robot has no limits for "
                               "it, so that paths turn it the shorter way")},
    .advice = {translatable("ErrorText", "Give the joint its limits in the description, or divide the motion.")}};

const ErrorDescription PostError::MotionDiffers{
    .id = "PostMotionDiffers",
    .sentences = {translatable("ErrorText", "the %2 of motion %1 is %4 in the program, and %3 in the path")},
    .advice = {
        translatable("ErrorText", "Report this to the author of the post-processor; the program was not written.")}};

}  // namespace handwheel
