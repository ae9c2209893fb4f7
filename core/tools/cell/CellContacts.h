// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "document/cell/CellScene.h"

#include <span>

namespace handwheel {

// What was found to collide in a cell that is shown, of one robot.
struct CellCollision {
  std::shared_ptr<const CellScene> scene;
  ArmValues values;                        // of the planned joints
  std::vector<RobotScene::Nearest> pairs;  // that meet
  Pose way = Pose::Identity();             // of the robot as a whole, where it is moved with its base
  // A body that is moved by hand, in place of the pairs; empty: none is.
  CollisionBody moved = {};
  Pose movedPose = Pose::Identity();
  std::vector<std::uint32_t> without = {};  // links that it does not collide with
};

// A place where two things in a cell touch.
struct CellContact {
  Vec3 place = Vec3::Zero();    // mm, in the frame of the cell: midway between the surfaces
  Vec3 normal = Vec3::UnitZ();  // of unit length, into the link that was found to collide
  double depth = 0.0;           // mm, at least 0
};

// The contacts of what collides, no two of one place; at most so many. The deepest of each pair come first, then the
// others, the deepest first. What is inside of something else without touching its surface has one, at the closest
// points. Any thread.
std::vector<CellContact> contactsOf(std::span<const CellCollision> collisions, std::size_t most, Progress progress);

}  // namespace handwheel
