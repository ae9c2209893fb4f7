// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "document/cell/CellScene.h"

#include <span>

namespace handwheel {

// Collisions of one robot in a displayed cell.
struct CellCollision {
  std::shared_ptr<const CellScene> scene;
  ArmValues values;                        // Values of the planned joints
  std::vector<RobotScene::Nearest> pairs;  // Colliding pairs
  Pose displacement = Pose::Identity();    // Displacement of the whole robot while it is moved with its base
  // A body that is moved by hand; its contacts replace those of the pairs. Empty: none.
  CollisionBody moved = {};
  Pose movedPose = Pose::Identity();
  std::vector<std::uint32_t> without = {};  // Links that the moved body is not tested against
};

// A contact of two objects in a cell.
struct CellContact {
  Vec3 position = Vec3::Zero();  // mm, in the frame of the cell: midway between the surfaces
  Vec3 normal = Vec3::UnitZ();   // Unit length, pointing into the link that collides
  double depth = 0.0;            // mm, at least 0
};

// Returns at most `most` contacts of the collisions, no two within 5 mm of each other. The deepest of each pair come
// first, then the others by depth. An object inside another without touching its surface has one contact, at the
// closest points. May be called on any thread.
std::vector<CellContact> contactsOf(std::span<const CellCollision> collisions, std::size_t most, Progress progress);

}  // namespace handwheel
