// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/HandGuidingTool.h"

namespace handwheel {

// State of HandGuidingTool from press to release.
struct HandGuidingTool::Guidance {
  std::shared_ptr<const CellScene> scene;  // The scene, to which the members below refer
  Teleoperation robot;
  ApproachForce approach;
  ArmValues start;
  Pose tool;                 // Pose of the tool at the press
  std::optional<Pose> hand;  // Pose of a device at the press
  Ray grip;                  // Ray of the mouse at the press
  double pixel;              // mm
  bool isTurning;            // True if the mouse turns the tool
  bool hasMoved = false;
  Vec3 wantedPosition = tool.translation();  // Position that the hand wants; mm
  Teleoperation::Step step = {};             // The last step
  ApproachForce::Felt felt = {};
  std::shared_ptr<const GuideCurve> guide = {};
  std::optional<FollowingTry> following = {};
  std::optional<PathWaypoint> pulled = {};  // The waypoint that is pulled instead of the robot
};

}  // namespace handwheel
