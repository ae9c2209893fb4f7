// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/CollisionBody.h"

#include <vector>

namespace handwheel {

// Pieces that stand still, prepared for the distances of bodies that move among them. Immutable once filled; any
// thread.
class ObstacleSet {
 public:
  // owner: a number of the caller's, by which it knows what was met.
  void add(const CollisionBody& body, const Pose& pose, std::uint32_t owner);
  std::size_t size() const { return m_obstacles.size(); }  // pieces

  struct Nearest {
    double distance;              // mm; at most 0: it meets an obstacle
    std::uint32_t owner = kNone;  // of that obstacle; kNone where none is nearer than asked for
  };
  // The distance of a body from the obstacles where it is below `enough`, else `enough`. Those of the owners that are
  // left out do not count. O(pieces of both).
  Nearest distance(const CollisionBody& body, const Pose& pose, double enough, std::span<const std::uint32_t> leftOut,
                   QueryCounts* counts = nullptr) const;

 private:
  struct Obstacle {
    CollisionPiece piece;  // in the world
    Pose toBox;            // from the world into the frame of its box
    Vec3 boxHalf;
    std::uint32_t owner;
  };
  std::vector<Obstacle> m_obstacles;
};

}  // namespace handwheel
