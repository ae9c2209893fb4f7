// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/HandGuidingTool.h"

namespace handwheel {

// What HandGuidingTool keeps from press to release.
struct HandGuidingTool::Guidance {
  std::shared_ptr<const CellScene> scene;  // what follows refers to it
  Teleoperation robot;
  ApproachForce approach;
  ArmValues start;
  Pose tool;                 // at the press
  std::optional<Pose> hand;  // of a device, at the press
  Ray grip;                  // of the mouse, at the press
  double pixel;              // mm
  bool isTurning;            // by the mouse
  bool hasMoved = false;
  Vec3 place = tool.translation();  // that the hand wants; mm
  Teleoperation::Step step = {};    // the last
  ApproachForce::Felt felt = {};
  std::shared_ptr<const GuideCurve> guide = {};
  std::optional<FollowingTry> following = {};
  std::optional<PathPlace> pulled = {};  // which is led, and not the robot
};

}  // namespace handwheel
