// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/PathCheck.h"

#include "document/cell/CellErrors.h"
#include "planning/CartesianLine.h"
#include "robot/dh/DhTable.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// The share of a motion, counted from one of its ends, in which the tool's centre point stays within `radius` of where
// it is there.
double shareWithin(const CellScene& scene, const Pose& tool, const ArmValues& end, const ArmValues& other,
                   double radius) {
  const Vec3 place = (scene.arm.tipPose(end) * tool).translation();
  constexpr int kParts = 64;
  constexpr double kMost = 0.5;  // controllers give a zone half of a motion
  for (int i = 1; i <= kParts; ++i) {
    const double share = kMost * i / kParts;
    const ArmValues values = end + share * (other - end);
    if (((scene.arm.tipPose(values) * tool).translation() - place).norm() > radius) return kMost * (i - 1) / kParts;
  }
  return kMost;
}

// The largest zone, at most the one that is wanted, in which every way between the two motions is free. What a
// controller does in it is not known but that it stays between the motions: everything is that far from the robot.
double certifiedBlend(const CellScene& scene, const Pose& tool, const ArmValues& before, const ArmValues& at,
                      const ArmValues& after, double wanted, double clearance) {
  constexpr double kFar = 1e6;  // mm
  const double distance =
      std::min(scene.scene.nearestObstacle(at, kFar).distance - clearance, scene.scene.nearest(at, kFar).distance);
  for (double radius = wanted; radius > 0.05 * wanted; radius *= 0.7) {
    const ArmValues in = at + shareWithin(scene, tool, at, before, radius) * (before - at);
    const ArmValues out = at + shareWithin(scene, tool, at, after, radius) * (after - at);
    const ArmValues spread = (in - at).cwiseAbs() + (out - at).cwiseAbs();
    // Parts of the robot may move towards each other.
    if (2.0 * scene.scene.travelBound(at, spread) < distance) return radius;
  }
  return 0.0;
}

std::vector<double> certifiedBlends(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                                    double clearance) {
  std::vector<double> blends(path.places.size(), 0.0);
  for (std::size_t i = 1; i + 1 < path.places.size(); ++i) {
    const PathPlace &place = path.places[i], &next = path.places[i + 1];
    const bool isJoint = place.motion == ProgramMotion::Kind::Joint && next.motion == ProgramMotion::Kind::Joint;
    if (place.blend <= 0.0 || !isJoint) continue;
    blends[i] = certifiedBlend(scene, plans.tool, scene.planned(path.places[i - 1].joints), scene.planned(place.joints),
                               scene.planned(next.joints), place.blend, clearance);
  }
  return blends;
}

}  // namespace

ResolvedPath resolved(const CellScene& scene, const CellPlans& plans, const RobotPath& path, Progress progress) {
  ResolvedPath way;
  for (std::size_t i = 0; i < path.places.size(); ++i) {
    const ArmValues values = scene.planned(path.places[i].joints);
    if (i > 0 && path.places[i].motion == ProgramMotion::Kind::Linear) {
      const FollowedLine line = followLine(scene.arm, plans.tool, way.joints.back(), values, {}, progress);
      way.joints.insert(way.joints.end(), line.path.begin() + 1, line.path.end());
      way.placeOf.resize(way.joints.size() - 1, i);
      if (line.reached >= 1.0) continue;
      way.stopsAt = i;
      way.reached = line.reached;
      return way;
    }
    way.joints.push_back(values);
    if (i > 0) way.placeOf.push_back(i);
  }
  return way;
}

std::vector<Vec3> toolCurve(const CellScene& scene, const CellPlans& plans, const RobotPath& path) {
  constexpr double kStep = 0.02;  // rad, mm: of the joint that moves most
  constexpr double kMostSteps = 4000.0;
  const JointPath way = resolved(scene, plans, path).joints;
  const double step = std::max(kStep, lengthOf(scene.scene, way) / kMostSteps);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const ArmValues& from = way[i == 0 ? 0 : i - 1];
    const int count = std::max(1, static_cast<int>(std::ceil((way[i] - from).cwiseAbs().maxCoeff() / step)));
    for (int k = 1; k <= count; ++k) {
      const ArmValues at = from + (static_cast<double>(k) / count) * (way[i] - from);
      points.push_back((scene.arm.tipPose(at) * plans.tool).translation());
    }
  }
  return points;
}

Result<CheckedPath> checkPath(const CellScene& scene, const CellPlans& plans, const RobotPath& path, double clearance,
                              Progress progress) {
  if (path.places.size() < 2) return Error{CellError::PathTooShort, {path.name}, {}, {}};
  for (std::size_t i = 0; i < path.places.size(); ++i) {
    const PathPlace& place = path.places[i];
    if (scene.standsAs(place.joints)) continue;
    return Error{CellError::OthersMoved, {place.name.empty() ? std::to_string(i + 1) : place.name}, {}, {}};
  }
  CheckedPath checked;
  checked.way = resolved(scene, plans, path, progress.part(0.0, 0.1));
  MotionCheckSettings check;
  check.clearance = clearance;
  const bool hasLines = std::any_of(path.places.begin(), path.places.end(),
                                    [](const PathPlace& place) { return place.motion == ProgramMotion::Kind::Linear; });
  if (hasLines) check.clearance += LineSettings().deviation;
  constexpr double kMarking = 0.01;  // rad
  checked.verification = verified(scene.scene, checked.way.joints, check, kMarking, progress.part(0.1, 0.6));
  checked.metrics = metricsOf(scene.scene, scene.arm, checked.way.joints, {}, progress.part(0.6, 0.95));
  checked.blends = certifiedBlends(scene, plans, path, clearance);
  checked.seconds = timed(scene, path, checked.way).duration();
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return checked;
}

TimedPath timed(const CellScene& scene, const RobotPath& path, const ResolvedPath& way) {
  std::vector<double> speeds;
  for (const std::size_t place : way.placeOf) {
    const PathPlace& to = path.places[place];
    speeds.push_back(to.motion == ProgramMotion::Kind::Joint ? to.speed : 1.0);
  }
  return TimedPath(scene.scene, way.joints, {}, speeds);
}

RobotProgram programOf(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                       const CheckedPath& checked) {
  RobotProgram program;
  program.name = path.name;
  program.robot = scene.robot->model.name;
  program.arm = scene.arm;
  program.tool = plans.tool;
  program.isBaseOfController = libraryRobot(scene.robot->model) != nullptr;
  program.hasPlainShapes = hasPlainShapes(scene.robot->model);
  for (std::size_t i = 0; i < path.places.size(); ++i) {
    const PathPlace& place = path.places[i];
    ProgramMotion motion{place.motion, scene.planned(place.joints), place.speed, checked.blends[i], place.name};
    if (i == 0) motion.kind = ProgramMotion::Kind::Joint;
    program.motions.push_back(std::move(motion));
  }
  return program;
}

}  // namespace handwheel
