// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/CartesianLine.h"
#include "planning/MotionCheck.h"
#include "planning/PartSurface.h"
#include "planning/RobotScene.h"

#include <span>

namespace handwheel {

// The attitude of a tool along a curve on a part. The tool's z axis points out of it, to the part; its x axis goes
// along the curve. Angles in rad.
struct ToolAttitude {
  double lead = 0.0;      // the tool leans back and points ahead; below 0 it leans ahead and drags its tip (lag)
  double tilt = 0.0;      // it leans to the right, as one goes along the curve on the surface
  double spin = 0.0;      // about the tool's own axis
  double standoff = 0.0;  // mm from the curve, back along the tool
};

// The poses of the tool's centre point along a curve.
std::vector<Pose> toolPoses(const SurfaceTrack& track, const ToolAttitude& attitude);

// How the joints for such poses are looked for.
struct TrackSettings {
  MotionCheckSettings check = {};
  LineSettings line = {};
  int spins = 1;  // turns of the tool about its own axis that may be chosen among, in equal steps; 1: only as it is
};

// The joints that bring a tool to poses one after the other.
struct FollowedTrack {
  enum class Outcome { Solved, OutOfReach, Blocked, NoWay, Cancelled };
  Outcome outcome = Outcome::NoWay;
  std::vector<ArmValues> values = {};  // one for each pose, when it is solved
  std::size_t failedAt = 0;            // the pose that cannot be reached, or not from the one before
  RobotScene::Nearest blocked{};       // what blocks the robot there
};

// Looks for the joints with the shortest way through all poses, each reached from the one before along a straight line
// of the tool, free of collisions all the way: among all ways in which the arm reaches each pose, as steps of a ladder
// (De Maeyer, Moyaers and Demeester 2017, Cartesian path planning for arc welding robots), beginning nearest to `near`.
// Steps and lines are checked only where the shortest way uses them. tool: of its centre point in the arm's tip.
FollowedTrack followTrack(const RobotScene& scene, const SerialArm& arm, const Pose& tool, std::span<const Pose> poses,
                          const ArmValues& near, const TrackSettings& settings, Progress progress = {});

// What became of a straight line of the tool, checked for collisions.
struct CheckedLine {
  double reached = 0.0;           // share of it that the arm can follow
  RobotScene::Nearest blocked{};  // no link: nothing is in the way
  std::uint64_t steps = 0;        // points that were looked at
  bool isFree() const { return reached >= 1.0 && blocked.link == kNone; }
};
CheckedLine checkLine(const RobotScene& scene, const SerialArm& arm, const Pose& tool, const ArmValues& from,
                      const ArmValues& to, const LineSettings& line, MotionCheckSettings check, Progress progress = {});

}  // namespace handwheel
