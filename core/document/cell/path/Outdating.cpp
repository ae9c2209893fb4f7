// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/path/Outdating.h"

#include "base/Units.h"
#include "document/cell/BodyCarriers.h"
#include "document/cell/CellArms.h"
#include "robot/Kinematics.h"

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
void compareStanding(const PathProcess& process, const Body& part, const Pose& base, Outdating& found) {
  const Pose planned = process.base.value_or(base);
  if (isSamePlace(base.inverse(Eigen::Isometry) * part.pose, planned.inverse(Eigen::Isometry) * process.planned))
    return;
  found.isBaseOther = !isSamePlace(base, planned);
  if (!found.isBaseOther || !isSamePlace(part.pose, process.planned)) found.part = part.name;
}

}  // namespace

bool isSamePlace(const Pose& one, const Pose& other) {
  constexpr double kDistance = 1e-3, kAngle = 1e-3 * kRadiansPerDegree;  // mm, rad
  const double angle = Eigen::Quaterniond(one.linear()).angularDistance(Eigen::Quaterniond(other.linear()));
  return (one.translation() - other.translation()).norm() <= kDistance && angle <= kAngle;
}

std::optional<Pose> targetInTool(const CellRobot& robot, const CellPlacement& cell, std::string_view arm,
                                 const JointValues& at, std::string_view target) {
  const NamedTarget* const known = cell.plans.target(target);
  const auto number = armNumber(robot, arm);
  if (!known || !number) return std::nullopt;
  const JointValues joints = jointsSetBy(robot, arm, at, cell.joints);
  const Result<Pose> pose = poseOfTarget(*known, {cell.plans, cell.bodies, cell.robot, joints});
  if (!pose) return std::nullopt;
  const Pose tool = linkPoses(cell.robot, joints)[robot.arms[*number].flange] * toolOf(robot, cell.plans, arm);
  return Pose(tool.inverse(Eigen::Isometry) * *pose);
}

Outdating outdatingOf(const CellRobot& robot, const CellPlacement& cell, const RobotPath& path) {
  Outdating found;
  if (path.process) {
    const BodyPointer part = standingPart(*path.process, cell);
    const auto number = armNumber(robot, path.arm);
    if (part && number) compareStanding(*path.process, *part, basePose(cell.robot, robot.arms[*number]), found);
    const std::optional<Pose>& tool = path.process->tool;
    found.isToolOther = tool && !isSamePlace(toolOf(robot, cell.plans, path.arm), *tool);
  }
  for (const Waypoint& place : path.places) {
    if (!place.target || found.targets.contains(place.target->name)) continue;
    const auto now = targetInTool(robot, cell, path.arm, place.joints, place.target->name);
    if (now && !isSamePlace(*now, place.target->inTool)) found.targets.insert(place.target->name);
  }
  return found;
}

}  // namespace handwheel
