// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/CartesianLine.h"
#include "planning/MotionCheck.h"
#include "planning/PartSurface.h"
#include "planning/RobotScene.h"

#include <span>

namespace handwheel {

// The attitude of a tool along a curve on a part. The z axis of the tool points from the tool to the part, its x axis
// along the curve. Angles are in rad.
struct ToolAttitude {
  double lead = 0.0;      // the tool leans back and points ahead; below 0: it leans ahead and drags its tip (lag)
  double tilt = 0.0;      // the tool leans to the right, seen along the curve
  double spin = 0.0;      // rotation about the tool's own axis
  double standoff = 0.0;  // mm: distance from the curve, back along the tool
};

// Returns the poses of the tool's centre point along a curve.
std::vector<Pose> toolPoses(const SurfaceTrack& track, const ToolAttitude& attitude);

// Settings for the search for the joint values of toolPoses().
struct TrackSettings {
  MotionCheckSettings check = {};
  LineSettings line = {};
  int spins = 1;  // number of rotations about the tool's axis to choose from, in equal steps; 1: only the given one
};

// The joint values that move a tool to several poses in turn.
struct FollowedTrack {
  enum class Outcome { Solved, OutOfReach, Blocked, NoPath, Cancelled };
  Outcome outcome = Outcome::NoPath;
  std::vector<ArmValues> values = {};  // one for each pose, if the outcome is Solved
  std::size_t failedAt = 0;            // index of the pose that cannot be reached at all or from the previous pose
  RobotScene::Nearest blocked{};       // the collision of the robot at this pose, or on the line to it
};

// Finds the joint values of the shortest path through all poses. Each pose is reached from the previous one along a
// straight line of the tool that is free of collisions. The IK solutions of each pose form a rung of a ladder graph (De
// Maeyer, Moyaers and Demeester 2017, Cartesian path planning for arc welding robots). Solutions and lines are checked
// only if the shortest path uses them. near: the joint values near which the path should begin. tool: the tool's centre
// point in the frame of the arm's tip.
FollowedTrack followTrack(const RobotScene& scene, const SerialArm& arm, const Pose& tool, std::span<const Pose> poses,
                          const ArmValues& near, const TrackSettings& settings, Progress progress = {});

// The result of the collision check of a straight line of the tool.
struct CheckedLine {
  double reached = 0.0;           // fraction of the line that the arm can follow
  RobotScene::Nearest blocked{};  // the collision; link kNone: there is no collision
  std::uint64_t steps = 0;        // number of points that were checked
  bool isFree() const { return reached >= 1.0 && blocked.link == kNone; }
};
CheckedLine checkLine(const RobotScene& scene, const SerialArm& arm, const Pose& tool, const ArmValues& from,
                      const ArmValues& to, const LineSettings& line, MotionCheckSettings check, Progress progress = {});

}  // namespace handwheel
