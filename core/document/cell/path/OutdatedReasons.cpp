// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/path/OutdatedReasons.h"

#include "base/Units.h"
#include "document/cell/BodyCarriers.h"
#include "document/cell/CellArms.h"
#include "robot/Kinematics.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// The part of a process, by its name or number; null where that is none, or not one alone, or a link carries it.
BodyPointer standingPart(const PathProcess& process, const CellPlacement& cell) {
  const auto value = process.values.find("part");
  const auto* const called = value == process.values.end() ? nullptr : std::get_if<std::string>(&value->second);
  BodyPointer part;
  for (const BodyPointer& body : cell.bodies) {
    if (!called || (body->name != *called && std::to_string(body->id) != *called)) continue;
    if (part) return nullptr;
    part = body;
  }
  return part && carrierOf(*part, cell.robot) == kNone ? part : nullptr;
}

// A part and a robot that were moved as one still meet: only where the part is for the base counts.
void compareStanding(const PathProcess& process, const Body& part, const Pose& base, OutdatedReasons& found) {
  const Pose planned = process.base.value_or(base);
  if (isSamePose(base.inverse(Eigen::Isometry) * part.pose, planned.inverse(Eigen::Isometry) * process.planned)) return;
  found.isBaseOther = !isSamePose(base, planned);
  if (!found.isBaseOther || !isSamePose(part.pose, process.planned)) found.part = part.name;
}

// The pose of something in the frame of the tool at these joint values; nothing if it, or the arm, is missing.
template <class PoseThere>
std::optional<Pose> inTool(const CellRobot& robot, const CellPlacement& cell, std::string_view arm,
                           const JointValues& at, const PoseThere& poseThere) {
  const auto number = armNumber(robot, arm);
  if (!number) return std::nullopt;
  const JointValues joints = jointsSetBy(robot, arm, at, cell.joints);
  const Result<Pose> pose = poseThere(CellPlacement{cell.plans, cell.bodies, cell.robot, joints});
  if (!pose) return std::nullopt;
  const Pose tool = linkPoses(cell.robot, joints)[robot.arms[*number].flange] * toolOf(robot, cell.plans, arm);
  return Pose(tool.inverse(Eigen::Isometry) * *pose);
}

}  // namespace

const NamedConfiguration* changedConfiguration(const CellRobot& robot, const CellPlans& plans, std::string_view arm,
                                               const Waypoint& waypoint) {
  constexpr double kAngle = 1e-3 * kRadiansPerDegree, kLength = 1e-3;  // rad, mm: as exactly as programs are read back
  const NamedConfiguration* const known = plans.configuration(waypoint.configuration);
  const auto number = armNumber(robot, arm);
  if (!known || !number || armNumber(robot, known->arm) != number) return nullptr;
  const auto isElsewhere = [&](std::uint32_t dof) {
    const double most = robot.model.jointOfDof(dof).kind == JointKind::Prismatic ? kLength : kAngle;
    return !(std::abs(known->joints[dof] - waypoint.joints[dof]) <= most);
  };
  const std::vector<std::uint32_t> dofs = dofsOfArm(robot, *number);
  return std::any_of(dofs.begin(), dofs.end(), isElsewhere) ? known : nullptr;
}

CellPlans withConfigurationRenamed(CellPlans plans, const std::string& name, const std::string& wanted) {
  for (NamedConfiguration& each : plans.configurations) {
    if (each.name == name) each.name = wanted;
  }
  for (RobotPath& path : plans.paths) {
    for (Waypoint& waypoint : path.waypoints) {
      if (waypoint.configuration != name) continue;
      waypoint.configuration = wanted;
      if (waypoint.name == name) waypoint.name = wanted;
    }
    for (const char* const end : {"from", "to"}) {
      if (!path.process) continue;
      const auto value = path.process->values.find(end);
      if (value != path.process->values.end() && value->second == PathProcess::Value(name)) value->second = wanted;
    }
  }
  return plans;
}

std::vector<std::string> pathsThrough(const CellPlans& plans, std::string_view configuration) {
  std::vector<std::string> names;
  for (const RobotPath& path : plans.paths) {
    const auto standsForIt = [&](const Waypoint& waypoint) { return waypoint.configuration == configuration; };
    if (std::any_of(path.waypoints.begin(), path.waypoints.end(), standsForIt)) names.push_back(path.name);
  }
  return names;
}

bool isSamePose(const Pose& one, const Pose& other) {
  constexpr double kDistance = 1e-3, kAngle = 1e-3 * kRadiansPerDegree;  // mm, rad
  const double angle = Eigen::Quaterniond(one.linear()).angularDistance(Eigen::Quaterniond(other.linear()));
  return (one.translation() - other.translation()).norm() <= kDistance && angle <= kAngle;
}

std::optional<Pose> targetInTool(const CellRobot& robot, const CellPlacement& cell, std::string_view arm,
                                 const JointValues& at, std::string_view target) {
  const NamedTarget* const known = cell.plans.target(target);
  if (!known) return std::nullopt;
  return inTool(robot, cell, arm, at, [&](const CellPlacement& there) { return poseOfTarget(*known, there); });
}

std::optional<Pose> frameInTool(const CellRobot& robot, const CellPlacement& cell, std::string_view arm,
                                const JointValues& at, std::string_view frame) {
  const NamedFrame* const known = cell.plans.frame(frame);
  if (!known) return std::nullopt;
  return inTool(robot, cell, arm, at, [&](const CellPlacement& there) { return poseOfFrame(*known, there); });
}

OutdatedReasons outdatedReasonsOf(const CellRobot& robot, const CellPlacement& cell, const RobotPath& path) {
  OutdatedReasons found;
  if (path.process) {
    const BodyPointer part = standingPart(*path.process, cell);
    const auto number = armNumber(robot, path.arm);
    if (part && number) compareStanding(*path.process, *part, basePose(cell.robot, robot.arms[*number]), found);
    const std::optional<Pose>& tool = path.process->tool;
    found.isToolOther = tool && !isSamePose(toolOf(robot, cell.plans, path.arm), *tool);
  }
  for (const Waypoint& waypoint : path.waypoints) {
    if (changedConfiguration(robot, cell.plans, path.arm, waypoint))
      found.configurations.insert(waypoint.configuration);
    if (waypoint.target && !found.targets.contains(waypoint.target->name)) {
      const auto now = targetInTool(robot, cell, path.arm, waypoint.joints, waypoint.target->name);
      if (now && !isSamePose(*now, waypoint.target->inTool)) found.targets.insert(waypoint.target->name);
    }
    if (!waypoint.frame || found.frames.contains(waypoint.frame->name)) continue;
    const auto now = frameInTool(robot, cell, path.arm, waypoint.joints, waypoint.frame->name);
    if (now && !isSamePose(*now, waypoint.frame->inTool)) found.frames.insert(waypoint.frame->name);
  }
  return found;
}

}  // namespace handwheel
