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
  std::vector<Error> damage;       // shapes and numbers that could not be understood and were left out
  std::size_t unlistedDamage = 0;  // further damage beyond the first thousand entries
};

// Reads a robot description in URDF. Lengths become millimetres. Everything that determines the motion of the robot
// must be valid: names unique, links joined to one tree, numbers finite, axes with a direction, limits in order. Damage
// elsewhere is listed, and the robot opens without that part. Floating and planar joints are held still, and listed.
// Mesh files are not read. O(bytes). Errors: ElementMalformed, ReferenceMissing, NumberMalformed, NumberNotFinite,
// CountMismatch, ValueOutOfRange, Unsupported (xacro), FileTooLarge, OutOfMemory, Cancelled; with the line.
Result<ImportedRobot> readUrdf(std::string_view bytes, Progress progress = {});

// Returns true if a file is a robot description, by its first bytes.
bool looksLikeUrdf(std::string_view head);

}  // namespace handwheel
