// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "robot/program/RobotPath.h"

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace handwheel {

// Writes the waypoints of a path as JSON. Each has its joint values under their names, its name and its motion.
// docs/robots.md has the keys.
nlohmann::json toJson(const RobotModel& robot, const RobotPath& path);

// Reads the waypoints from such JSON, or only "waypoints": lists of numbers in the order of "joints", or of these
// degrees of freedom (none: all of the robot's). Missing joints have the values of `others`. Errors: ElementMalformed
// {element, reason}, ReferenceMissing {joint}, ValueOutOfRange {joint, value, least, largest}, FileTooLarge.
Result<RobotPath> pathFrom(const nlohmann::json& json, const RobotModel& robot, const JointValues& others,
                           std::vector<std::uint32_t> columns = {});
// Reads them from a file's text; errors of parseJson(), too.
Result<RobotPath> readPath(std::string_view text, const RobotModel& robot, const JointValues& others,
                           std::vector<std::uint32_t> columns = {});

// Writes a pose as twelve numbers, row by row: the rotation and, last in each row, the position.
nlohmann::json numbersOfPose(const Pose& pose);

// Converts joint values to and from JSON under the names of the joints; missing ones have the values of `others`.
// Errors: those of pathFrom().
nlohmann::json toJson(const RobotModel& robot, const JointValues& joints);
Result<JointValues> jointsFrom(const nlohmann::json& json, const RobotModel& robot, const JointValues& others);

// Returns the values for a path: values slightly beyond a limit because of printed digits are brought back onto it, so
// that planning and verification, which are stricter, accept them. Error if a value is beyond the limits of its joint,
// or a revolute joint beyond kMostTurn: ValueOutOfRange {joint, value, least, largest; rad, mm}.
Result<JointValues> valuesWithinLimits(const RobotModel& robot, JointValues joints);

}  // namespace handwheel
