// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/CollisionBody.h"

#include <array>
#include <map>
#include <vector>

namespace handwheel {

// Obstacles that do not move, prepared for distance queries with moving bodies. After the last add() the set may be
// used on any thread.
class ObstacleSet {
 public:
  // Adds a body. owner: a number chosen by the caller to identify it.
  void add(const CollisionBody& body, const Pose& pose, std::uint32_t owner);
  std::size_t size() const { return m_obstacles.size(); }  // number of pieces

  // Returns the obstacles as one body for each owner, in the world.
  std::map<std::uint32_t, CollisionBody> bodies() const;

  struct Nearest {
    double distance;              // mm; at most 0: the body intersects or touches an obstacle
    std::uint32_t owner = kNone;  // owner of the nearest obstacle; kNone: no obstacle is nearer than `enough`
  };
  // Returns the distance of a body from the obstacles if it is below `enough`, otherwise `enough`. Obstacles of the
  // owners in leftOut are ignored. O(pieces of the body · pieces of the obstacles).
  Nearest distance(const CollisionBody& body, const Pose& pose, double enough, std::span<const std::uint32_t> leftOut,
                   QueryCounts* counts = nullptr) const;

  // Finds the obstacles (by index) that may be nearer to a sphere than `enough`. The result serves for several bodies
  // in the sphere. The list is cleared first. O(pieces).
  void findNear(const Vec3& centre, double radius, double enough, std::vector<std::uint32_t>& near,
                QueryCounts* counts = nullptr) const;
  // Returns the distance of a body from the obstacles with the indices in `among`, which findNear() found.
  Nearest distance(const CollisionBody& body, const Pose& pose, double enough, std::span<const std::uint32_t> leftOut,
                   std::span<const std::uint32_t> among, QueryCounts* counts = nullptr) const;

 private:
  // A box around an obstacle, for the first test. Boxes are stored apart from the obstacles, because they are accessed
  // very often.
  struct Bound {
    Eigen::Matrix3d turn;  // rotation from the world into the frame of the box
    Vec3 shift, half;
    Vec3 inside(const Vec3& p) const { return turn.lazyProduct(p) + shift; }
    // Returns true if a point in the frame of the box is at least this far from the box.
    bool isApart(const Vec3& p, double distance) const {
      const Vec3 out = (p.cwiseAbs() - half).cwiseMax(0.0);
      return distance <= 0.0 || out.squaredNorm() >= distance * distance;
    }
  };
  // Four bounds that are tested at once with vector instructions.
  struct FourBounds {
    using Four = Eigen::Array4d;
    std::array<Four, 9> turn;  // row by row
    std::array<Four, 3> shift, half;
    FourBounds();
    void set(Eigen::Index i, const Bound& bound);
    Four squaredDistances(const Vec3& p) const;
  };
  struct Obstacle {
    CollisionPiece piece;  // in world coordinates
    std::uint32_t owner;
  };
  std::vector<FourBounds> m_fours;  // m_bounds in groups of four, in the same order
  std::vector<Bound> m_bounds;
  std::vector<Obstacle> m_obstacles;
};

}  // namespace handwheel
