// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/CellProperties.h"

#include "base/NumberText.h"
#include "document/cell/CellReach.h"
#include "document/cell/path/RateProperties.h"
#include "scene/RigidPose.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace handwheel {

namespace {

constexpr std::string_view kPrefix = "joint.";
const std::string kBase = "robot.";

bool turns(const Joint& joint) {
  return joint.kind != JointKind::Prismatic;
}

constexpr const char* kTool = QT_TRANSLATE_NOOP("Property", "Tool");
constexpr std::pair<const char*, const char*> kPoseFields[] = {
    {"x", QT_TRANSLATE_NOOP("Property", "X")},
    {"y", QT_TRANSLATE_NOOP("Property", "Y")},
    {"z", QT_TRANSLATE_NOOP("Property", "Z")},
    {"rx", QT_TRANSLATE_NOOP("Property", "Rotate about X")},
    {"ry", QT_TRANSLATE_NOOP("Property", "Rotate about Y")},
    {"rz", QT_TRANSLATE_NOOP("Property", "Rotate about Z")},
};
constexpr double kRounding = 1e-9;  // mm, rad: what kinematics leave of a 0
constexpr const char* kJoints = QT_TRANSLATE_NOOP("Property", "Joints");

// In a cell with several robots each has a group, in which its joints are called as in its own description.
void groupByRobot(std::vector<Property>& joints, const CellRobot& cell) {
  if (cell.arms.size() < 2) return;
  const std::vector<std::uint32_t> owners = armsOfDofs(cell.model, cell.arms);
  for (std::size_t dof = 0; dof < joints.size(); ++dof) {
    if (owners[dof] == kNone) continue;
    const std::string& name = cell.arms[owners[dof]].name;
    joints[dof].group = name;
    joints[dof].groupTranslated = false;
    if (joints[dof].label.starts_with(name + '_')) joints[dof].label.erase(0, name.size() + 1);
  }
  std::vector<std::size_t> order(joints.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return owners[a] < owners[b]; });
  std::vector<Property> grouped;
  grouped.reserve(order.size());
  for (const std::size_t dof : order) grouped.push_back(std::move(joints[dof]));
  joints = std::move(grouped);
}

Property jointProperty(const Joint& joint, double value) {
  Property property;
  property.id = std::string(kPrefix) + joint.name;
  property.group = kJoints;
  property.label = joint.name;
  property.translated = false;
  property.value = value;
  property.quantity = turns(joint) ? Quantity::Angle : Quantity::Length;
  if (joint.kind == JointKind::Continuous) {  // one turn, and those that the joint is wound up by
    const double wound = 2.0 * std::numbers::pi * std::round(value / (2.0 * std::numbers::pi));
    property.least = std::min(wound, 0.0) - std::numbers::pi;
    property.largest = std::max(wound, 0.0) + std::numbers::pi;
  } else {
    property.least = joint.limits.lower;
    property.largest = joint.limits.upper;
  }
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

// Returns the joints for which the file does not give this limit; nothing if it gives all. Generators write 0 for
// unknown limits, so this is common.
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

// Returns the properties that only a cell with several robots has.
std::vector<Property> armProperties(const CellRobot& cell, const CellPlans& plans) {
  std::vector<Property> all;
  if (cell.arms.size() > 1) {
    Property chosen = toRead("arm", kTool, QT_TRANSLATE_NOOP("Property", "Robot to plan for"),
                             static_cast<double>(activeArmNumber(cell, plans)), Quantity::Number);
    for (const RobotArm& arm : cell.arms) chosen.choices.push_back(arm.name);
    chosen.least = 0.0;
    chosen.largest = static_cast<double>(cell.arms.size() - 1);
    chosen.editable = true;
    all.push_back(std::move(chosen));
  }
  for (const RobotArm& arm : cell.arms) {
    if (arm.base == cell.model.root) continue;
    for (Property& each : poseProperties(kBase + arm.name + '.', arm.name, basePose(cell.model, arm))) {
      each.groupTranslated = false;
      all.push_back(std::move(each));
    }
  }
  return all;
}

Property choiceOf(std::string id, const std::string& group, const char* label, std::vector<std::string> choices,
                  std::size_t chosen) {
  Property property;
  property.id = std::move(id);
  property.group = group;
  property.label = label;
  property.choices = std::move(choices);
  property.value = static_cast<double>(chosen);
  property.least = 0.0;
  property.largest = static_cast<double>(property.choices.size() - 1);
  return property;
}

// None, then the frames.
Property frameChoice(std::string id, const std::string& group, const char* label, const CellPlans& plans,
                     const std::string& chosen) {
  std::vector<std::string> choices{QT_TRANSLATE_NOOP("Property", "none")};
  std::size_t number = 0;
  for (const NamedFrame& frame : plans.frames) {
    if (frame.name == chosen) number = choices.size();
    choices.push_back(frame.name);
  }
  return choiceOf(std::move(id), group, label, std::move(choices), number);
}

// The number of a choice of frameChoice() as a name; none: it is no such number.
std::optional<std::string> frameChosen(const PropertyValue& value, const CellPlans& plans) {
  const auto* const number = std::get_if<double>(&value);
  if (!number || !(*number >= 0.0 && *number <= static_cast<double>(plans.frames.size()))) return std::nullopt;
  const auto index = static_cast<std::size_t>(*number);
  return index == 0 ? std::string() : plans.frames[index - 1].name;
}

std::optional<NamedField> namedField(std::string_view kind, const std::string& id) {
  const std::size_t last = id.rfind('.');
  if (!id.starts_with(kind) || last == id.npos || last < kind.size()) return std::nullopt;
  return NamedField{id.substr(kind.size(), last - kind.size()), id.substr(last + 1)};
}

Error noNumber(const std::string& id) {
  return {ErrorCode::ElementMalformed, {id, "a number was expected"}, {}, {}};
}

Error tooFar(const std::string& id, const PropertyValue& value) {
  const std::string most = shownText(kFarthestBody);
  return {ErrorCode::ValueOutOfRange, {id, shownText(std::get<double>(value)), "-" + most, most}, {}, {}};
}

// The frame with another of the choices of frameProperties() carrying it.
Result<NamedFrame> withCarrier(const NamedFrame& frame, const std::string& id, const PropertyValue& value,
                               const CellPlacement& cell) {
  const auto* const number = std::get_if<double>(&value);
  const std::size_t links = cell.robot.links.size();
  if (!number || !(*number >= 0.0 && *number <= static_cast<double>(links + cell.bodies.size()))) return noNumber(id);
  const auto index = static_cast<std::size_t>(*number);
  if (index == 0) return carriedFrame(frame, 0, {}, cell);
  if (index <= links) return carriedFrame(frame, 0, cell.robot.links[index - 1].name, cell);
  const auto body = std::next(cell.bodies.begin(), static_cast<std::ptrdiff_t>(index - links - 1));
  return carriedFrame(frame, (*body)->id, {}, cell);
}

Result<NamedFrame> changedFrame(const NamedFrame& frame, const std::string& field, const std::string& id,
                                const PropertyValue& value, const CellPlacement& cell) {
  if (field == "carrier") return withCarrier(frame, id, value, cell);
  const auto pose = changedPose(frame.pose, field, value);
  if (!pose) return noNumber(id);
  if (!isRigid(*pose)) return tooFar(id, value);
  NamedFrame moved = frame;
  moved.pose = *pose;
  return moved;
}

Result<NamedTarget> changedTarget(const NamedTarget& target, const std::string& field, const std::string& id,
                                  const PropertyValue& value, const CellPlacement& cell) {
  if (field == "frame") {
    const auto chosen = frameChosen(value, cell.plans);
    if (!chosen) return noNumber(id);
    return *chosen == target.frame ? Result<NamedTarget>(target) : targetInFrame(target, *chosen, cell);
  }
  const auto pose = changedPose(shownPose(target, cell), field, value);
  if (!pose) return noNumber(id);
  NamedTarget moved = targetShownAt(target, *pose, cell);
  if (!isRigid(*pose) || !isRigid(moved.pose)) return tooFar(id, value);
  return moved;
}

std::string shown(double value, const Joint& joint) {
  return shownText(turns(joint) ? value / kRadiansPerDegree : value);
}

}  // namespace

std::vector<Property> cellProperties(const CellRobot& cell, const JointValues& joints, const CellPlans& plans) {
  const RobotModel& robot = cell.model;
  std::vector<Property> all;
  for (std::size_t dof = 0; dof < robot.dofs.size(); ++dof)
    all.push_back(jointProperty(robot.jointOfDof(dof), joints[static_cast<Eigen::Index>(dof)]));
  groupByRobot(all, cell);
  for (auto limit : {unknownLimits(robot, "joints.unknown_speed", QT_TRANSLATE_NOOP("Property", "Speed not known"),
                                   &JointLimits::velocity),
                     unknownLimits(robot, "joints.unknown_effort", QT_TRANSLATE_NOOP("Property", "Effort not known"),
                                   &JointLimits::effort)}) {
    if (limit) all.push_back(*std::move(limit));
  }
  const char* const kRobot = QT_TRANSLATE_NOOP("Property", "Robot");
  std::string titles;
  for (const RobotArm& arm : cell.arms) titles += (titles.empty() ? "" : ", ") + arm.title;
  all.push_back(toRead("robot", kRobot, QT_TRANSLATE_NOOP("Property", "Name"), titles, Quantity::Number));
  bool isPlain = false;
  for (std::size_t i = 0; i < cell.arms.size(); ++i) isPlain |= hasPlainShapes(robot, cell.arms, i);
  if (isPlain) {
    Property shapes = toRead("robot.shapes", kRobot, QT_TRANSLATE_NOOP("Property", "Shapes"), 0.0, Quantity::Number);
    shapes.choices = {QT_TRANSLATE_NOOP("Property", "simplified: keep a clearance")};
    all.push_back(std::move(shapes));
  }
  for (Property& each : armProperties(cell, plans)) all.push_back(std::move(each));
  if (!plans.frames.empty())
    all.push_back(frameChoice("frame", QT_TRANSLATE_NOOP("Property", "Coordinates and programs"),
                              QT_TRANSLATE_NOOP("Property", "In the frame"), plans, plans.workFrame));
  const std::string& link = robot.links[activeArm(cell, plans).flange].name;
  all.push_back(toRead("tool", kTool, QT_TRANSLATE_NOOP("Property", "Link"), link, Quantity::Number));
  for (Property& each : toolProperties(toolPose(cell, plans, joints))) all.push_back(std::move(each));
  const char* const kCentre = QT_TRANSLATE_NOOP("Property", "Tool centre point, on the flange");
  for (Property& each : poseProperties("tcp.", kCentre, plans.tool)) all.push_back(std::move(each));
  for (Property& each : rateProperties(plans.rates)) all.push_back(std::move(each));
  return all;
}

std::vector<Property> poseProperties(const std::string& prefix, const std::string& group, const Pose& pose) {
  const Vec3 angles = rollPitchYaw(pose);
  std::vector<Property> all;
  for (std::size_t i = 0; i < std::size(kPoseFields); ++i) {
    const auto& [field, label] = kPoseFields[i];
    const auto axis = static_cast<Eigen::Index>(i % 3);
    const double value = i < 3 ? pose.translation()[axis] : angles[axis];
    Property property = toRead("", group.c_str(), label, std::abs(value) < kRounding ? 0.0 : value,
                               i < 3 ? Quantity::Length : Quantity::Angle);
    property.id = prefix + field;
    property.editable = true;
    all.push_back(std::move(property));
  }
  return all;
}

std::vector<Property> toolProperties(const Pose& pose) {
  return poseProperties("tool.", kTool, pose);
}

std::vector<Property> frameProperties(const NamedFrame& frame, const CellPlacement& cell) {
  const std::string prefix = "frame." + frame.name + '.';
  std::vector<std::string> choices{QT_TRANSLATE_NOOP("Property", "nothing")};
  std::size_t chosen = 0;
  for (const Link& link : cell.robot.links) {
    if (frame.body == 0 && link.name == frame.link) chosen = choices.size();
    choices.push_back(link.name);
  }
  for (const BodyPointer& body : cell.bodies) {
    if (frame.body == body->id) chosen = choices.size();
    choices.push_back(body->name);
  }
  std::vector<Property> all{choiceOf(prefix + "carrier", frame.name, QT_TRANSLATE_NOOP("Property", "Carried by"),
                                     std::move(choices), chosen)};
  if (chosen == 0 && (frame.body != 0 || !frame.link.empty()))
    all.front().problem = QT_TRANSLATE_NOOP("Property", "what carried it was removed");
  for (Property& each : poseProperties(prefix, frame.name, frame.pose)) all.push_back(std::move(each));
  for (Property& each : all) each.groupTranslated = false;
  return all;
}

std::vector<Property> targetProperties(const NamedTarget& target, const CellPlacement& cell) {
  const std::string prefix = "target." + target.name + '.';
  std::vector<Property> all;
  if (!cell.plans.frames.empty())
    all.push_back(frameChoice(prefix + "frame", target.name, QT_TRANSLATE_NOOP("Property", "Moves with the frame"),
                              cell.plans, target.frame));
  const std::string in = shownIn(target, cell);
  Property coordinates =
      toRead("", target.name.c_str(), QT_TRANSLATE_NOOP("Property", "Coordinates in"), in, Quantity::Number);
  coordinates.id = prefix + "coordinates";
  if (in.empty()) {
    coordinates.choices = {QT_TRANSLATE_NOOP("Property", "the cell")};
    coordinates.value = 0.0;
  }
  all.push_back(std::move(coordinates));
  for (Property& each : poseProperties(prefix, target.name, shownPose(target, cell))) all.push_back(std::move(each));
  for (Property& each : all) each.groupTranslated = false;
  return all;
}

std::optional<NamedField> fieldOfFrame(const std::string& id) {
  return namedField("frame.", id);
}

std::optional<NamedField> fieldOfTarget(const std::string& id) {
  return namedField("target.", id);
}

Result<CellPlans> changedFrameOrTarget(const std::string& id, const PropertyValue& value, const CellPlacement& cell) {
  CellPlans plans = cell.plans;
  if (id == "frame") {
    auto chosen = frameChosen(value, plans);
    if (!chosen) return noNumber(id);
    plans.workFrame = *std::move(chosen);
    return plans;
  }
  if (const auto field = fieldOfFrame(id)) {
    for (NamedFrame& frame : plans.frames) {
      if (frame.name != field->name) continue;
      Result<NamedFrame> changed = changedFrame(frame, field->field, id, value, cell);
      if (!changed) return changed.error();
      frame = std::move(changed).value();
      return plans;
    }
  }
  if (const auto field = fieldOfTarget(id)) {
    for (NamedTarget& target : plans.targets) {
      if (target.name != field->name) continue;
      Result<NamedTarget> changed = changedTarget(target, field->field, id, value, cell);
      if (!changed) return changed.error();
      target = std::move(changed).value();
      return plans;
    }
  }
  return Error{ErrorCode::ReferenceMissing, {"the property", id}, {}, {}};
}

std::optional<BaseField> baseOfProperty(const CellRobot& robot, const std::string& id) {
  const std::size_t last = id.rfind('.');
  if (!id.starts_with(kBase) || last < kBase.size() || last == id.npos) return std::nullopt;
  const std::string name = id.substr(kBase.size(), last - kBase.size());
  const auto arm = name.empty() ? std::nullopt : armNumber(robot, name);
  if (!arm) return std::nullopt;
  return BaseField{*arm, id.substr(last + 1)};
}

std::optional<Pose> changedPose(const Pose& pose, std::string_view field, const PropertyValue& value) {
  const auto* const found = std::find_if(std::begin(kPoseFields), std::end(kPoseFields),
                                         [&](const auto& each) { return each.first == field; });
  const auto* const number = std::get_if<double>(&value);
  if (found == std::end(kPoseFields) || !number || !std::isfinite(*number)) return std::nullopt;
  const auto index = found - std::begin(kPoseFields);
  Vec3 position = pose.translation(), angles = rollPitchYaw(pose);
  (index < 3 ? position : angles)[index % 3] = *number;
  return poseOf(position, angles);
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
  const double least = joint.nearest(-HUGE_VAL), largest = joint.nearest(HUGE_VAL);
  if (const auto kept = withinShownLimits(*number, least, largest)) return *kept;
  return Error{ErrorCode::ValueOutOfRange,
               {joint.name, shown(*number, joint), shown(least, joint), shown(largest, joint)},
               {},
               {}};
}

}  // namespace handwheel
