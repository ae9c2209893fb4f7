// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Property.h"
#include "document/cell/CellFrames.h"
#include "document/cell/RobotCellSnapshot.h"

#include <optional>

namespace handwheel {

// Returns the properties of a robot cell. In this order they are: for each degree of freedom "joint.<name>", labelled
// with the joint's name, with its limits, in one group per robot if there are several; read-only, the joints without a
// known speed or effort, and the robot's name; with several robots, the one that is planned for ("arm", a choice) and
// the poses of the robots that are not on the root ("robot.NAME.x" to "robot.NAME.rz"); if the cell has frames, the
// frame of programs and coordinates ("frame", a choice); the link that carries the tool; the pose of the tool centre
// point in the frame of the root ("tool.x" to "tool.rz"; mm, rad, as for bodies), and its pose in the frame of the link
// ("tcp.x" to "tcp.rz").
std::vector<Property> cellProperties(const CellRobot& robot, const JointValues& joints, const CellPlans& plans);

// The robot and the field of its pose that a property "robot.NAME.x" denotes.
struct BaseField {
  std::size_t arm;
  std::string field;
};
std::optional<BaseField> baseOfProperty(const CellRobot& robot, const std::string& id);

// Returns the properties of a frame: its carrier ("frame.NAME.carrier", a choice of nothing, the links and the bodies),
// and its pose relative to the carrier ("frame.NAME.x" to "frame.NAME.rz").
std::vector<Property> frameProperties(const NamedFrame& frame, const CellPlacement& cell);
// Returns the properties of a target: its frame if the cell has frames ("target.NAME.frame", a choice), and its
// shownPose() ("target.NAME.x" to "target.NAME.rz").
std::vector<Property> targetProperties(const NamedTarget& target, const CellPlacement& cell);

// The name, which may contain dots, and the field of a property "frame.NAME.x" or "target.NAME.x".
struct NamedField {
  std::string name;
  std::string field;
};
std::optional<NamedField> fieldOfFrame(const std::string& id);
std::optional<NamedField> fieldOfTarget(const std::string& id);

// Returns the plans with a property of a frame or target, or the property "frame", changed. A frame or target keeps its
// pose when its carrier or frame changes. Errors: ReferenceMissing, ElementMalformed, ValueOutOfRange; the errors of
// carriedFrame() and targetInFrame().
Result<CellPlans> changedFrameOrTarget(const std::string& id, const PropertyValue& value, const CellPlacement& cell);

// Returns the degree of freedom of a joint property; kNone for other properties.
std::uint32_t dofOfProperty(const RobotModel& robot, std::string_view id);

// Returns the properties of a pose. Their ids consist of the prefix and x, y, z (mm), rx, ry, rz (rad).
std::vector<Property> poseProperties(const std::string& prefix, const std::string& group, const Pose& pose);
// Returns the properties of the tool's pose, "tool.x" to "tool.rz".
std::vector<Property> toolProperties(const Pose& pose);
// Returns the pose with one of the fields of poseProperties() changed; nothing for other fields, and for values that
// are not finite numbers.
std::optional<Pose> changedPose(const Pose& pose, std::string_view field, const PropertyValue& value);

// Converts a property value to a joint value; a limit may be given as it is displayed, that is, rounded. Errors:
// ElementMalformed, ValueOutOfRange {name, value, least, largest; degrees or mm}.
Result<double> jointValueFrom(const RobotModel& robot, std::uint32_t dof, const PropertyValue& value);

}  // namespace handwheel
