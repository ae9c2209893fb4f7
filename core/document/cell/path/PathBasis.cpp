// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/path/PathBasis.h"

#include "document/cell/CellArms.h"
#include "robot/arm/SerialArm.h"

#include <algorithm>

namespace handwheel {

namespace {

bool collideAlike(const BodySet& one, const BodySet& other) {
  const auto isAlike = [](const BodyPointer& a, const BodyPointer& b) {
    return a == b || (a->id == b->id && a->geometry == b->geometry && a->carrier == b->carrier &&
                      a->pose.matrix() == b->pose.matrix());
  };
  return std::equal(one.begin(), one.end(), other.begin(), other.end(), isAlike);
}

// Both of the same robots.
bool standAlike(const PathBasis& basis, const JointValues& joints) {
  JointValues others = joints;
  for (const std::uint32_t dof : basis.planned) others[dof] = basis.joints[dof];
  return others == basis.joints;
}

}  // namespace

std::vector<std::uint32_t> plannedDofs(const CellRobot& robot, std::string_view arm) {
  const auto number = armNumber(robot, arm);
  if (!number) return {};
  auto planned = SerialArm::of(robot.model, robot.model.root, robot.arms[*number].flange);
  return planned ? std::move(planned->dofs) : std::vector<std::uint32_t>();
}

PathBasis basisOf(const RobotCellSnapshot& cell, const RobotPath& path) {
  return {path,
          cell.robot,
          cell.bodies,
          cell.joints,
          plannedDofs(*cell.robot, path.arm),
          cell.plans->allowed,
          toolOf(*cell.robot, *cell.plans, path.arm),
          cell.plans->clearanceOf(path),
          targetsOf(*cell.plans, path),
          configurationsOf(*cell.robot, *cell.plans, path),
          cell.plans->rates};
}

std::vector<std::vector<double>> configurationsOf(const CellRobot& robot, const CellPlans& plans,
                                                  const RobotPath& path) {
  std::vector<std::vector<double>> all;
  const auto arm = armNumber(robot, path.arm);
  const std::vector<std::uint32_t> dofs = arm ? dofsOfArm(robot, *arm) : std::vector<std::uint32_t>();
  for (const Waypoint& waypoint : path.waypoints) {
    if (waypoint.configuration.empty()) continue;
    all.emplace_back();
    const NamedConfiguration* const known = plans.configuration(waypoint.configuration);
    if (!known || armNumber(robot, known->arm) != arm) continue;
    for (const std::uint32_t dof : dofs) all.back().push_back(known->joints[dof]);
  }
  return all;
}

std::vector<std::pair<NamedTarget, NamedFrame>> targetsOf(const CellPlans& plans, const RobotPath& path) {
  std::vector<std::pair<NamedTarget, NamedFrame>> targets;
  for (const Waypoint& waypoint : path.waypoints) {
    const auto add = [&](const NamedTarget* target, const NamedFrame* frame) {
      targets.emplace_back(target ? *target : NamedTarget(), frame ? *frame : NamedFrame());
      targets.back().first.name = targets.back().first.frame = targets.back().second.name = {};
    };
    const NamedTarget* const target = waypoint.target ? plans.target(waypoint.target->name) : nullptr;
    if (waypoint.target) add(target, target ? plans.frame(target->frame) : nullptr);
    if (waypoint.frame) add(nullptr, plans.frame(waypoint.frame->name));
  }
  return targets;
}

BasisChange changeSince(const PathBasis& basis, const RobotCellSnapshot& cell, const RobotPath& path) {
  if (basis.robot != cell.robot) return BasisChange::Robots;
  if (!haveSameWaypoints(basis.path, path)) return BasisChange::Path;
  if (!standAlike(basis, cell.joints)) return BasisChange::Joints;
  if (!collideAlike(basis.bodies, cell.bodies)) return BasisChange::Bodies;
  if (basis.allowed != cell.plans->allowed) return BasisChange::Pairs;
  if (basis.tool.matrix() != toolOf(*cell.robot, *cell.plans, path.arm).matrix()) return BasisChange::Tool;
  if (basis.clearance != cell.plans->clearanceOf(path)) return BasisChange::Clearance;
  if (basis.targets != targetsOf(*cell.plans, path)) return BasisChange::Targets;
  if (basis.configurations != configurationsOf(*cell.robot, *cell.plans, path)) return BasisChange::Configurations;
  if (basis.rates != cell.plans->rates) return BasisChange::Rates;
  return BasisChange::Nothing;
}

bool haveSameWaypoints(const RobotPath& one, const RobotPath& other) {
  const auto isSameBase = [](const auto& a, const auto& b) {
    return a.first == b.first && a.second.matrix() == b.second.matrix();
  };
  return one.arm == other.arm && one.waypoints == other.waypoints &&
         std::equal(one.bases.begin(), one.bases.end(), other.bases.begin(), other.bases.end(), isSameBase);
}

}  // namespace handwheel
