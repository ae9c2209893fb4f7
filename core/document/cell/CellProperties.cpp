// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/CellProperties.h"

#include "base/NumberText.h"
#include "document/cell/CellReach.h"
#include "scene/RigidPose.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace handwheel {

namespace {

constexpr std::string_view kPrefix = "joint.";
constexpr std::string_view kToolPrefix = "tool.";
constexpr std::string_view kCentrePrefix = "tcp.";

bool turns(const Joint& joint) {
  return joint.kind != JointKind::Prismatic;
}

constexpr const char* kTool = QT_TRANSLATE_NOOP("Property", "Tool");
constexpr std::pair<const char*, const char*> kToolFields[] = {
    {"tool.x", QT_TRANSLATE_NOOP("Property", "X")},
    {"tool.y", QT_TRANSLATE_NOOP("Property", "Y")},
    {"tool.z", QT_TRANSLATE_NOOP("Property", "Z")},
    {"tool.rx", QT_TRANSLATE_NOOP("Property", "Rotate about X")},
    {"tool.ry", QT_TRANSLATE_NOOP("Property", "Rotate about Y")},
    {"tool.rz", QT_TRANSLATE_NOOP("Property", "Rotate about Z")},
};
constexpr const char* kJoints = QT_TRANSLATE_NOOP("Property", "Joints");

Property jointProperty(const Joint& joint, double value) {
  Property property;
  property.id = std::string(kPrefix) + joint.name;
  property.group = kJoints;
  property.label = joint.name;
  property.translated = false;
  property.value = value;
  property.quantity = turns(joint) ? Quantity::Angle : Quantity::Length;
  property.least = joint.kind == JointKind::Continuous ? -std::numbers::pi : joint.limits.lower;
  property.largest = joint.kind == JointKind::Continuous ? std::numbers::pi : joint.limits.upper;
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

// Of which joints the file does not give this limit; none where it gives all. Generators write 0 where they do not
// know, so this is common.
std::optional<Property> unknownLimits(const RobotModel& robot, const char* id, const char* label,
                                      std::optional<double> JointLimits::*limit) {
  std::string names;
  std::size_t count = 0;
  for (std::size_t dof = 0; dof < robot.dofs.size(); ++dof) {
    const Joint& joint = robot.jointOfDof(dof);
    if (joint.limits.*limit) continue;
    names += (count++ > 0 ? ", " : "") + joint.name;
  }
  if (count == 0) return {};
  Property property = toRead(id, kJoints, label, names, Quantity::Number);
  if (count < robot.dofs.size()) return property;
  property.value = 0.0;
  property.choices = {QT_TRANSLATE_NOOP("Property", "all joints")};
  return property;
}

std::string shown(double value, const Joint& joint) {
  return shownText(turns(joint) ? value / kRadiansPerDegree : value);
}

}  // namespace

std::vector<Property> cellProperties(const RobotModel& robot, const JointValues& joints, const Pose& tool) {
  std::vector<Property> all;
  for (std::size_t dof = 0; dof < robot.dofs.size(); ++dof)
    all.push_back(jointProperty(robot.jointOfDof(dof), joints[static_cast<Eigen::Index>(dof)]));
  for (auto limit : {unknownLimits(robot, "joints.unknown_speed", QT_TRANSLATE_NOOP("Property", "Speed not known"),
                                   &JointLimits::velocity),
                     unknownLimits(robot, "joints.unknown_effort", QT_TRANSLATE_NOOP("Property", "Effort not known"),
                                   &JointLimits::effort)}) {
    if (limit) all.push_back(*std::move(limit));
  }
  const char* const kRobot = QT_TRANSLATE_NOOP("Property", "Robot");
  all.push_back(toRead("robot", kRobot, QT_TRANSLATE_NOOP("Property", "Name"), robot.name, Quantity::Number));
  const std::string& link = robot.links[toolLink(robot)].name;
  all.push_back(toRead("tool", kTool, QT_TRANSLATE_NOOP("Property", "Link"), link, Quantity::Number));
  for (Property& each : toolProperties(toolPose(robot, tool, joints))) all.push_back(std::move(each));
  for (Property& each : toolProperties(tool)) {
    each.id = std::string(kCentrePrefix) + each.id.substr(kToolPrefix.size());
    each.group = QT_TRANSLATE_NOOP("Property", "Tool centre point, on the flange");
    all.push_back(std::move(each));
  }
  return all;
}

std::vector<Property> toolProperties(const Pose& pose) {
  const Vec3 angles = rollPitchYaw(pose);
  std::vector<Property> all;
  for (std::size_t i = 0; i < std::size(kToolFields); ++i) {
    const auto& [id, label] = kToolFields[i];
    const auto axis = static_cast<Eigen::Index>(i % 3);
    const double exact = i < 3 ? pose.translation()[axis] : angles[axis];
    constexpr double kNothing = 1e-9;  // mm, rad: what rounding leaves
    Property property =
        toRead(id, kTool, label, std::abs(exact) < kNothing ? 0.0 : exact, i < 3 ? Quantity::Length : Quantity::Angle);
    property.editable = true;
    all.push_back(std::move(property));
  }
  return all;
}

std::optional<Pose> changedCentre(const Pose& centre, std::string_view id, const PropertyValue& value) {
  if (!id.starts_with(kCentrePrefix)) return std::nullopt;
  return changedToolPose(centre, std::string(kToolPrefix) + std::string(id.substr(kCentrePrefix.size())), value);
}

std::optional<Pose> changedToolPose(const Pose& pose, std::string_view id, const PropertyValue& value) {
  const auto* const field =
      std::find_if(std::begin(kToolFields), std::end(kToolFields), [&](const auto& each) { return each.first == id; });
  const auto* const number = std::get_if<double>(&value);
  if (field == std::end(kToolFields) || !number || !std::isfinite(*number)) return std::nullopt;
  const auto index = field - std::begin(kToolFields);
  Vec3 place = pose.translation(), angles = rollPitchYaw(pose);
  (index < 3 ? place : angles)[index % 3] = *number;
  return poseOf(place, angles);
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
  const double least = joint.limits.nearest(-HUGE_VAL), largest = joint.limits.nearest(HUGE_VAL);
  if (const auto kept = withinShownLimits(*number, least, largest)) return *kept;
  return Error{ErrorCode::ValueOutOfRange,
               {joint.name, shown(*number, joint), shown(least, joint), shown(largest, joint)},
               {},
               {}};
}

}  // namespace handwheel
