// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/CollisionBody.h"

#include <array>
#include <map>
#include <vector>

namespace handwheel {

// Pieces that stand still, prepared for the distances of bodies that move among them. Immutable once filled; any
// thread.
class ObstacleSet {
 public:
  // owner: a number of the caller's, by which it knows what was met.
  void add(const CollisionBody& body, const Pose& pose, std::uint32_t owner);
  std::size_t size() const { return m_obstacles.size(); }  // pieces

  // Them by their owners, in the world.
  std::map<std::uint32_t, CollisionBody> bodies() const;

  struct Nearest {
    double distance;              // mm; at most 0: it meets an obstacle
    std::uint32_t owner = kNone;  // of that obstacle; kNone where none is nearer than asked for
  };
  // The distance of a body from the obstacles where it is below `enough`, else `enough`. Those of the owners that are
  // left out do not count. O(pieces of both).
  Nearest distance(const CollisionBody& body, const Pose& pose, double enough, std::span<const std::uint32_t> leftOut,
                   QueryCounts* counts = nullptr) const;

  // The obstacles (by number) that may be nearer to a sphere than so much, for several bodies in that sphere. Those
  // that were in the list before are not any more. O(pieces).
  void findNear(const Vec3& centre, double radius, double enough, std::vector<std::uint32_t>& near,
                QueryCounts* counts = nullptr) const;
  // The distance from these obstacles.
  Nearest distance(const CollisionBody& body, const Pose& pose, double enough, std::span<const std::uint32_t> leftOut,
                   std::span<const std::uint32_t> among, QueryCounts* counts = nullptr) const;

 private:
  // A box around an obstacle, for the first look at it: by itself in memory, as it is looked at very often.
  struct Bound {
    Eigen::Matrix3d turn;  // from the world into the frame of the box
    Vec3 shift, half;
    Vec3 inside(const Vec3& p) const { return turn.lazyProduct(p) + shift; }
    // Whether a sphere around a point in the frame of the box is at least so far from the box.
    bool isApart(const Vec3& p, double distance) const {
      const Vec3 out = (p.cwiseAbs() - half).cwiseMax(0.0);
      return distance <= 0.0 || out.squaredNorm() >= distance * distance;
    }
  };
  // The same of four of them at once: processors compute several numbers in one step.
  struct FourBounds {
    using Four = Eigen::Array4d;
    std::array<Four, 9> turn;  // row by row
    std::array<Four, 3> shift, half;
    FourBounds();
    void set(Eigen::Index i, const Bound& bound);
    Four squaredDistances(const Vec3& p) const;
  };
  struct Obstacle {
    CollisionPiece piece;  // in the world
    std::uint32_t owner;
  };
  std::vector<FourBounds> m_fours;  // of m_bounds, in order
  std::vector<Bound> m_bounds;
  std::vector<Obstacle> m_obstacles;
};

}  // namespace handwheel
