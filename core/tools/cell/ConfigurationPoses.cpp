// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/ConfigurationPoses.h"

#include "document/cell/CellErrors.h"
#include "document/cell/CellFrames.h"
#include "document/scene/BodyChanges.h"
#include "document/scene/BodyErrors.h"
#include "scene/RigidPose.h"
#include "tools/scene/BodyOperation.h"
#include "tools/scene/PlaceParameters.h"

#include <algorithm>

namespace handwheel {

namespace {

const NamedTarget* targetToGoTo(const OperationValues& values, const CellPlans& plans) {
  return values.isSet("go") && !plans.configuration(values.text("go")) ? plans.target(values.text("go")) : nullptr;
}

CellPlacement placementIn(const RobotCellSnapshot& cell, const CellPlans& plans) {
  return {plans, cell.bodies, cell.robot->model, cell.joints};
}

std::optional<Error> problemOfWaypointName(const std::string& name) {
  if (isBodyName(name)) return std::nullopt;
  return Error{BodyError::NameUnusable, {name, std::to_string(kLongestBodyName)}, {}, {}};
}

// Replaces the one of the same name, or appends.
template <class Named>
void store(std::vector<Named>& all, Named made) {
  const auto same = std::find_if(all.begin(), all.end(), [&](const Named& each) { return each.name == made.name; });
  if (same != all.end())
    *same = std::move(made);
  else
    all.push_back(std::move(made));
}

}  // namespace

bool goesToTarget(const OperationValues& values, const CellPlans& plans) {
  return targetToGoTo(values, plans) != nullptr;
}

bool movesTool(const OperationValues& values, const CellPlans& plans) {
  if (values.isSet("add-target") || values.isSet("add-frame")) return false;
  return values.isSet("at") || values.isSet("turn") || values.isSet("solution") || targetToGoTo(values, plans);
}

Result<Pose> givenPose(const OperationValues& values, const RobotCellSnapshot& cell) {
  if (const NamedTarget* const target = targetToGoTo(values, *cell.plans))
    return poseOfTarget(*target, placementIn(cell, *cell.plans));
  Pose pose = toolPose(*cell.robot, *cell.plans, cell.joints);
  if (values.isSet("turn")) pose = poseOf(pose.translation(), vectorIn(values, "turn"));
  if (values.isSet("at")) pose.translation() = vectorIn(values, "at");
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
  const auto nearest = [&]() -> Result<JointValues> {
    const Result<ArmValues> found = nearestFree(*scene, *cell.plans, *pose, near);
    return found ? Result<JointValues>(scene->whole(*found)) : found.error();
  };
  if (!solution) return nearest();
  const std::vector<CellIkSolution> solutions = ikSolutionsTo(*scene, *cell.plans, *pose, near);
  const auto possible = static_cast<std::size_t>(std::count_if(
      solutions.begin(), solutions.end(), [](const CellIkSolution& each) { return each.isWithinLimits(); }));
  if (possible == 0) return nearest();  // Gives the reason
  const auto index = static_cast<std::size_t>(*solution) - 1;
  if (index < possible) return scene->whole(solutions[index].arm.values);
  return Error{
      ErrorCode::ValueOutOfRange, {"solution", std::to_string(index + 1), "1", std::to_string(possible)}, {}, {}};
}

Status changeTargets(const OperationValues& values, const RobotCellSnapshot& cell, CellPlans& plans) {
  if (values.isSet("remove-target")) {
    const std::string name = values.text("remove-target");
    if (!plans.target(name)) return Error{CellError::WaypointMissing, {name}, {}, {}};
    plans = withoutTarget(std::move(plans), name);
  }
  if (!values.isSet("add-target")) return Done{};
  NamedTarget target{.name = values.text("add-target")};
  if (const auto problem = problemOfWaypointName(target.name)) return *problem;
  if (plans.configuration(target.name)) return Error{CellError::WaypointNameTaken, {target.name}, {}, {}};
  const Result<Pose> pose = givenPose(values, cell);
  if (!pose) return pose.error();
  target.pose = *pose;
  if (values.isSet("on")) {
    const Result<BodyPointer> body = bodyCalled(cell.bodies, values.text("on"));
    if (!body) return body.error();
    target = onBody(std::move(target), **body, cell.robot->model, cell.joints);
  }
  if (values.isSet("in")) {
    Result<NamedTarget> inFrame = targetInFrame(std::move(target), values.text("in"), placementIn(cell, plans));
    if (!inFrame) return inFrame.error();
    target = std::move(inFrame).value();
  }
  store(plans.targets, std::move(target));
  return Done{};
}

Status changeFrames(const OperationValues& values, const RobotCellSnapshot& cell, CellPlans& plans) {
  if (values.isSet("remove-frame")) {
    const std::string name = values.text("remove-frame");
    if (!plans.frame(name)) return Error{CellError::FrameMissing, {name}, {}, {}};
    plans = withoutFrame(name, placementIn(cell, plans));
  }
  if (!values.isSet("add-frame")) return Done{};
  NamedFrame frame{.name = values.text("add-frame")};
  if (const auto problem = problemOfWaypointName(frame.name)) return *problem;
  const Result<Pose> pose = givenPose(values, cell);
  if (!pose) return pose.error();
  frame.pose = *pose;
  std::uint32_t carrier = 0;
  if (values.isSet("on")) {
    const Result<BodyPointer> body = bodyCalled(cell.bodies, values.text("on"));
    if (!body) return body.error();
    carrier = (*body)->id;
  }
  const std::string link = values.isSet("link") ? values.text("link") : std::string();
  Result<NamedFrame> carried = carriedFrame(std::move(frame), carrier, link, placementIn(cell, plans));
  if (!carried) return carried.error();
  store(plans.frames, std::move(carried).value());
  return Done{};
}

}  // namespace handwheel
