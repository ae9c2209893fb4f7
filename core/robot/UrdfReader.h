// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "robot/RobotModel.h"

#include <string_view>

namespace handwheel {

// A robot with the damage found in its description.
struct ImportedRobot {
  RobotModel robot;
  std::vector<Error> damage;       // parts that could not be understood and were omitted
  std::size_t unlistedDamage = 0;  // number of further damaged parts after the first thousand
};

// Reads a robot description in URDF. Lengths are converted to mm. The elements that determine the motion of the robot
// must be valid: names are unique, links form one tree, numbers are finite, axes have a direction, and limits are in
// order. Damage in other elements is listed, and the robot is read without them. Floating and planar joints become
// fixed and are listed. Mesh files are not read. O(bytes). Errors: ElementMalformed, ReferenceMissing, NumberMalformed,
// NumberNotFinite, CountMismatch, ValueOutOfRange, Unsupported (xacro), FileTooLarge, OutOfMemory, Cancelled. Errors
// contain the line.
Result<ImportedRobot> readUrdf(std::string_view bytes, Progress progress = {});

// Returns true if a file is a robot description, according to its first bytes.
bool looksLikeUrdf(std::string_view head);

}  // namespace handwheel
