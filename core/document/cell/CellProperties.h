// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Property.h"
#include "robot/RobotModel.h"

#include <optional>

namespace handwheel {

// The properties of a robot cell. One for each degree of freedom ("joint.<name>", labelled with the joint's name), with
// its limits; then, read-only, which joints have no known speed or effort, the robot's name and the link that carries
// its tool; then the pose of the tool's centre point, which is `tool` in that link ("tool.x" to "tool.rz"; mm and rad
// as of bodies, in the frame of the robot's base); then that of the centre point in the link ("tcp.x" to "tcp.rz").
std::vector<Property> cellProperties(const RobotModel& robot, const JointValues& joints, const Pose& tool);

// The degree of freedom of a joint property; kNone for other properties.
std::uint32_t dofOfProperty(const RobotModel& robot, std::string_view id);

// The properties of a pose: prefix and x, y, z (mm), rx, ry, rz (rad).
std::vector<Property> poseProperties(const std::string& prefix, const std::string& group, const Pose& pose);
// Those of a pose of the tool, "tool.x" to "tool.rz".
std::vector<Property> toolProperties(const Pose& pose);
// The pose with one of these fields changed; none for others, and for values that are no finite numbers.
std::optional<Pose> changedPose(const Pose& pose, std::string_view field, const PropertyValue& value);

// Converts a property value to a joint value; a limit may be given as it is shown. Errors: ElementMalformed,
// ValueOutOfRange {name, value, least, largest; degrees or mm}.
Result<double> jointValueFrom(const RobotModel& robot, std::uint32_t dof, const PropertyValue& value);

}  // namespace handwheel
