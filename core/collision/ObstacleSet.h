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
  // A box around an obstacle, for the first look at it: by itself in memory, as it is looked at very often.
  struct Bound {
    Eigen::Matrix3d turn;  // from the world into the frame of the box
    Vec3 shift, half;
    Vec3 inside(const Vec3& p) const { return turn * p + shift; }
    // Whether a sphere around a point in the frame of the box is at least so far from the box.
    bool isApart(const Vec3& p, double distance) const {
      const Vec3 out = (p.cwiseAbs() - half).cwiseMax(0.0);
      return distance <= 0.0 || out.squaredNorm() >= distance * distance;
    }
  };
  struct Obstacle {
    CollisionPiece piece;  // in the world
    std::uint32_t owner;
  };
  std::vector<Bound> m_bounds;
  std::vector<Obstacle> m_obstacles;
};

}  // namespace handwheel
