// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "robot/program/RobotPath.h"

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace handwheel {

// The places of a path as JSON. Of each its joint values under their names, what it is called, and its motion.
// docs/robots.md has the keys.
nlohmann::json toJson(const RobotModel& robot, const RobotPath& path);

// The places from such JSON, or only "waypoints": lists of numbers in the order of "joints", or of these degrees of
// freedom (none: all of the robot's). Joints that are not in it are those of `others`. Errors: ElementMalformed
// {element, reason}, ReferenceMissing {joint}, ValueOutOfRange {joint, value, least, largest}, FileTooLarge.
Result<RobotPath> pathFrom(const nlohmann::json& json, const RobotModel& robot, const JointValues& others,
                           std::vector<std::uint32_t> columns = {});
// The same from a file's text; errors of parseJson(), too.
Result<RobotPath> readPath(std::string_view text, const RobotModel& robot, const JointValues& others,
                           std::vector<std::uint32_t> columns = {});

// A pose as twelve numbers, row by row: the turn and, last in each row, the place.
nlohmann::json numbersOfPose(const Pose& pose);

// Joint values under the names of the joints that move, and back; what is missing is that of `others`. Errors: as
// pathFrom().
nlohmann::json toJson(const RobotModel& robot, const JointValues& joints);
Result<JointValues> jointsFrom(const nlohmann::json& json, const RobotModel& robot, const JointValues& others);

// The values as paths take them: what printed digits put beyond a limit is brought back onto it, so that planning and
// verification, which allow less, agree with what was read. Error where a value is beyond the limits of its joint, or a
// revolute joint beyond kMostTurn: ValueOutOfRange {joint, value, least, largest; rad, mm}.
Result<JointValues> valuesWithinLimits(const RobotModel& robot, JointValues joints);

}  // namespace handwheel
