// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "robot/program/RobotPath.h"

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace handwheel {

// Writes the waypoints of a path as JSON. Each has its joint values by the names of the joints, its name and its
// motion. docs/robots.md describes the keys.
nlohmann::json toJson(const RobotModel& robot, const RobotPath& path);

// Reads the waypoints of a path from JSON. It may have the form that toJson() writes, or only "waypoints": lists of
// numbers in the order of "joints", or else of columns. columns: degrees of freedom; empty: all of the robot. Missing
// joints have the values of `others`. Errors: ElementMalformed {element, reason}, ReferenceMissing {joint},
// ValueOutOfRange {joint, value, least, largest}, FileTooLarge.
Result<RobotPath> pathFrom(const nlohmann::json& json, const RobotModel& robot, const JointValues& others,
                           std::vector<std::uint32_t> columns = {});
// Reads the waypoints of a path from the text of a file. Errors: the errors of parseJson() and pathFrom().
Result<RobotPath> readPath(std::string_view text, const RobotModel& robot, const JointValues& others,
                           std::vector<std::uint32_t> columns = {});

// Writes a pose as twelve numbers, row by row: the rotation and, last in each row, the position.
nlohmann::json numbersOfPose(const Pose& pose);

// Converts joint values to and from JSON, by the names of the joints; missing joints have the values of `others`.
// Errors: the errors of pathFrom().
nlohmann::json toJson(const RobotModel& robot, const JointValues& joints);
Result<JointValues> jointsFrom(const nlohmann::json& json, const RobotModel& robot, const JointValues& others);

// Returns joint values within the limits. Values that exceed a limit only because of printed digits are set to the
// limit, as planning and verification demand. Errors: ValueOutOfRange {joint, value, least, largest; rad, mm} if a
// value is beyond the limits of its joint, or a revolute joint beyond kMostTurn.
Result<JointValues> valuesWithinLimits(const RobotModel& robot, JointValues joints);

}  // namespace handwheel
