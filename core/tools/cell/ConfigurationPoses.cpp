// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/ConfigurationPoses.h"

#include "document/cell/CellErrors.h"
#include "document/scene/BodyChanges.h"
#include "document/scene/BodyErrors.h"
#include "scene/RigidPose.h"
#include "tools/scene/BodyOperation.h"

#include <algorithm>

namespace handwheel {

namespace {

Vec3 vectorOf(const OperationValues& values, const char* id) {
  const std::vector<double> numbers = values.numbers(id);
  return {numbers[0], numbers[1], numbers[2]};
}

const NamedTarget* targetToGoTo(const OperationValues& values, const CellPlans& plans) {
  return values.isSet("go") && !plans.configuration(values.text("go")) ? plans.target(values.text("go")) : nullptr;
}

}  // namespace

bool goesToTarget(const OperationValues& values, const CellPlans& plans) {
  return targetToGoTo(values, plans) != nullptr;
}

bool movesTool(const OperationValues& values, const CellPlans& plans) {
  if (values.isSet("add-target")) return false;
  return values.isSet("at") || values.isSet("turn") || values.isSet("solution") || targetToGoTo(values, plans);
}

Result<Pose> givenPose(const OperationValues& values, const RobotCellSnapshot& cell) {
  const RobotModel& robot = cell.robot->model;
  if (const NamedTarget* const target = targetToGoTo(values, *cell.plans))
    return poseOfTarget(*target, cell.bodies, robot, cell.joints);
  Pose pose = toolPose(*cell.robot, *cell.plans, cell.joints);
  if (values.isSet("turn")) pose = poseOf(pose.translation(), vectorOf(values, "turn"));
  if (values.isSet("at")) pose.translation() = vectorOf(values, "at");
  return pose;
}

Result<JointValues> jointsThere(const OperationValues& values, const RobotCellSnapshot& cell) {
  const Result<Pose> pose = givenPose(values, cell);
  if (!pose) return pose.error();
  CollisionMeshes meshes;
  const Result<CellScene> scene = sceneOf(cell, meshes);
  if (!scene) return scene.error();
  const ArmValues near = scene->planned(cell.joints);
  const auto solution = values.given("solution");
  if (!solution) {
    const Result<ArmValues> found = nearestFree(*scene, *cell.plans, *pose, near);
    return found ? Result<JointValues>(scene->whole(*found)) : found.error();
  }
  const std::vector<CellIkSolution> ways = ikSolutionsTo(*scene, *cell.plans, *pose, near);
  const auto possible = static_cast<std::size_t>(
      std::count_if(ways.begin(), ways.end(), [](const CellIkSolution& way) { return way.isWithinLimits(); }));
  const auto index = static_cast<std::size_t>(*solution) - 1;
  if (index < possible) return scene->whole(ways[index].arm.values);
  return Error{
      ErrorCode::ValueOutOfRange, {"solution", std::to_string(index + 1), "1", std::to_string(possible)}, {}, {}};
}

Status changeTargets(const OperationValues& values, const RobotCellSnapshot& cell, CellPlans& plans) {
  if (values.isSet("remove-target")) {
    const std::string name = values.text("remove-target");
    if (!plans.target(name)) return Error{CellError::PlaceMissing, {name}, {}, {}};
    std::erase_if(plans.targets, [&](const NamedTarget& each) { return each.name == name; });
  }
  if (!values.isSet("add-target")) return Done{};
  NamedTarget target{.name = values.text("add-target")};
  if (!isBodyName(target.name))
    return Error{BodyError::NameUnusable, {target.name, std::to_string(kLongestBodyName)}, {}, {}};
  if (plans.configuration(target.name)) return Error{CellError::PlaceNameTaken, {target.name}, {}, {}};
  const Result<Pose> pose = givenPose(values, cell);
  if (!pose) return pose.error();
  target.pose = *pose;
  if (values.isSet("on")) {
    const Result<BodyPointer> body = bodyCalled(cell.bodies, values.text("on"));
    if (!body) return body.error();
    target = onBody(std::move(target), **body, cell.robot->model, cell.joints);
  }
  const auto same = std::find_if(plans.targets.begin(), plans.targets.end(),
                                 [&](const NamedTarget& each) { return each.name == target.name; });
  if (same != plans.targets.end())
    *same = std::move(target);
  else
    plans.targets.push_back(std::move(target));
  return Done{};
}

}  // namespace handwheel
