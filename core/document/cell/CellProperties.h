// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Property.h"
#include "document/cell/CellFrames.h"
#include "document/cell/RobotCellSnapshot.h"

#include <optional>

namespace handwheel {

// The properties of a robot cell. One for each degree of freedom ("joint.<name>", labelled with the joint's name), with
// its limits, of several robots in a group for each; then, read-only, which joints have no known speed or effort and
// the robot's name; of several robots which one is planned for ("arm", a choice) and where those stand that are not on
// the root ("robot.NAME.x" to "robot.NAME.rz"); the frame of programs and coordinates, where the cell has frames
// ("frame", a choice); the link that carries the tool; then the pose of the tool's centre point ("tool.x" to "tool.rz";
// mm and rad as of bodies, in the frame of the root); then that of the centre point in the link ("tcp.x" to "tcp.rz").
std::vector<Property> cellProperties(const CellRobot& robot, const JointValues& joints, const CellPlans& plans);

// "robot.NAME.x": which of the robots stands there, and the field of its pose. None: that is no such property.
struct BaseField {
  std::size_t arm;
  std::string field;
};
std::optional<BaseField> baseOfProperty(const CellRobot& robot, const std::string& id);

// The properties of a frame: what carries it ("frame.NAME.carrier", a choice of nothing, the links and the bodies), and
// its pose in that ("frame.NAME.x" to "frame.NAME.rz").
std::vector<Property> frameProperties(const NamedFrame& frame, const CellPlacement& cell);
// Those of a target: where the cell has frames that which it belongs to ("target.NAME.frame", a choice), and its
// shownPose() ("target.NAME.x" to "target.NAME.rz").
std::vector<Property> targetProperties(const NamedTarget& target, const CellPlacement& cell);

// "frame.NAME.x", "target.NAME.x": the name, which may have points, and the field; none: it is of another kind.
struct NamedField {
  std::string name;
  std::string field;
};
std::optional<NamedField> fieldOfFrame(const std::string& id);
std::optional<NamedField> fieldOfTarget(const std::string& id);

// The plans with one of these properties, or with "frame", changed. A frame and a target keep their places when they
// come to something else. Errors: ReferenceMissing, ElementMalformed, ValueOutOfRange; those of carriedFrame() and
// targetInFrame().
Result<CellPlans> changedPlaceOf(const std::string& id, const PropertyValue& value, const CellPlacement& cell);

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
