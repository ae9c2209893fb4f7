// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/RobotOperation.h"

#include "document/cell/CellArms.h"
#include "document/cell/CellErrors.h"
#include "document/cell/RobotChanges.h"
#include "scene/RigidPose.h"
#include "tools/scene/PlaceParameters.h"

#include <QtGlobal>
#include <algorithm>
#include <numbers>

namespace handwheel {

namespace {

constexpr const char* kRobotVerbs[] = {"add", "remove", "choose"};
constexpr const char* kOfAdding[] = {"name", "at", "turn"};

}  // namespace

const Operation& robotOperation() {
  static const Operation kOperation = {
      .id = "robot",
      .title = QT_TRANSLATE_NOOP("Tool", "Change robots"),
      .meaning = "Adds a robot to a cell, removes one, or chooses the one to plan for",
      .parameters = {
          wordParameter("add", "ROBOT",
                        "Add a robot: a URDF, a table after Denavit and Hartenberg, or a built-in one (irb120)"),
          wordParameter("name", "NAME", "Name of the new robot (default: that of its description)"),
          threeNumbers("at", "X,Y,Z", "Position of its base, in mm from that of the first robot", Quantity::Length,
                       kFarthestBody),
          threeNumbers("turn", "A,B,C", "Rotation of its base about x, y and z in degrees", Quantity::Angle,
                       2.0 * std::numbers::pi),
          wordParameter("remove", "NAME", "Remove a robot with its configurations and paths"),
          wordParameter("choose", "NAME", "The robot to plan for from now on")}};
  return kOperation;
}

std::string problemOfRobotValues(const OperationValues& values) {
  const auto isSet = [&](const char* id) { return values.isSet(id); };
  if (std::count_if(std::begin(kRobotVerbs), std::end(kRobotVerbs), isSet) != 1)
    return "one of add, remove and choose is needed";
  if (!isSet("add") && std::any_of(std::begin(kOfAdding), std::end(kOfAdding), isSet))
    return "name, at and turn need add";
  return {};
}

Result<RobotCellSnapshot> withRobotsChanged(const OperationValues& values, const RobotCellSnapshot& cell,
                                            const std::shared_ptr<const RobotCellSnapshot>& added) {
  if (added) {
    const std::string name = values.isSet("name") ? values.text("name") : std::string();
    return withRobotAdded(cell, {added, name, poseOf(vectorIn(values, "at"), vectorIn(values, "turn"))});
  }
  const std::string name = values.text(values.isSet("remove") ? "remove" : "choose");
  const auto number = name.empty() ? std::nullopt : armNumber(*cell.robot, name);
  if (!number) return Error{CellError::ArmMissing, {name}, {}, {}};
  if (values.isSet("remove")) return withRobotRemoved(cell, *number);
  Result<CellPlans> plans = withArmChosen(*cell.robot, *cell.plans, name);
  if (!plans) return plans.error();
  RobotCellSnapshot changed = cell;
  changed.plans = std::make_shared<const CellPlans>(std::move(plans).value());
  return changed;
}

}  // namespace handwheel
