// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/CellProperties.h"

#include "robot/Kinematics.h"

#include <QString>
#include <QtGlobal>
#include <cmath>
#include <numbers>

namespace handwheel {

namespace {

constexpr std::string_view kPrefix = "joint.";

bool turns(const Joint& joint) {
  return joint.kind != JointKind::Prismatic;
}

// Generators write 0 where they do not know, so this is common.
const char* unknownOf(const JointLimits& limits) {
  if (!limits.effort && !limits.velocity) return QT_TRANSLATE_NOOP("Property", "speed and effort are not known");
  if (!limits.effort) return QT_TRANSLATE_NOOP("Property", "effort is not known");
  if (!limits.velocity) return QT_TRANSLATE_NOOP("Property", "speed is not known");
  return "";
}

Property jointProperty(const Joint& joint, double value) {
  Property property;
  property.id = std::string(kPrefix) + joint.name;
  property.group = QT_TRANSLATE_NOOP("Property", "Joints");
  property.label = joint.name;
  property.translated = false;
  property.value = value;
  property.quantity = turns(joint) ? Quantity::Angle : Quantity::Length;
  property.least = joint.kind == JointKind::Continuous ? -std::numbers::pi : joint.limits.lower;
  property.largest = joint.kind == JointKind::Continuous ? std::numbers::pi : joint.limits.upper;
  property.problem = unknownOf(joint.limits);
  property.continuous = property.largest - property.least < kFarthestTravel;
  return property;
}

Property toRead(const char* id, const char* group, const char* label, PropertyValue value, Quantity quantity) {
  Property property;
  property.id = id;
  property.group = group;
  property.label = label;
  property.value = std::move(value);
  property.quantity = quantity;
  property.editable = false;
  return property;
}

std::string shown(double value, const Joint& joint) {
  return QString::number(turns(joint) ? value / kRadiansPerDegree : value).toStdString();
}

}  // namespace

std::vector<Property> cellProperties(const RobotModel& robot, const JointValues& joints) {
  std::vector<Property> all;
  for (std::size_t dof = 0; dof < robot.dofs.size(); ++dof)
    all.push_back(jointProperty(robot.jointOfDof(dof), joints[static_cast<Eigen::Index>(dof)]));
  const char* const kRobot = QT_TRANSLATE_NOOP("Property", "Robot");
  all.push_back(toRead("robot", kRobot, QT_TRANSLATE_NOOP("Property", "Name"), robot.name, Quantity::Number));
  const std::uint32_t tool = toolLink(robot);
  const Vec3 at = linkPoses(robot, joints)[tool].translation();
  const char* const kTool = QT_TRANSLATE_NOOP("Property", "Tool");
  all.push_back(toRead("tool", kTool, QT_TRANSLATE_NOOP("Property", "Link"), robot.links[tool].name, Quantity::Number));
  all.push_back(toRead("tool.x", kTool, QT_TRANSLATE_NOOP("Property", "X"), at.x(), Quantity::Length));
  all.push_back(toRead("tool.y", kTool, QT_TRANSLATE_NOOP("Property", "Y"), at.y(), Quantity::Length));
  all.push_back(toRead("tool.z", kTool, QT_TRANSLATE_NOOP("Property", "Z"), at.z(), Quantity::Length));
  return all;
}

std::uint32_t dofOfProperty(const RobotModel& robot, std::string_view id) {
  if (!id.starts_with(kPrefix)) return kNone;
  for (std::uint32_t dof = 0; dof < robot.dofs.size(); ++dof) {
    if (robot.jointOfDof(dof).name == id.substr(kPrefix.size())) return dof;
  }
  return kNone;
}

Result<double> jointValueFrom(const RobotModel& robot, std::uint32_t dof, const PropertyValue& value) {
  const Joint& joint = robot.jointOfDof(dof);
  const auto* number = std::get_if<double>(&value);
  if (!number || !std::isfinite(*number))
    return Error{ErrorCode::ElementMalformed, {joint.name, "a number was expected"}, {}, {}};
  if (joint.limits.nearest(*number) == *number) return *number;
  const double least = joint.limits.nearest(-HUGE_VAL), largest = joint.limits.nearest(HUGE_VAL);
  return Error{ErrorCode::ValueOutOfRange,
               {joint.name, shown(*number, joint), shown(least, joint), shown(largest, joint)},
               {},
               {}};
}

}  // namespace handwheel
