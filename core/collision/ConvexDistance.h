// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/CollisionBody.h"

namespace handwheel {

// A convex shape. It is a triangle or a solid; a sphere is represented by its centre, and the caller accounts for its
// radius. All shapes are in one frame; lengths are in mm.
struct ConvexShape {
  CollisionPiece::Kind kind = CollisionPiece::Kind::Mesh;  // Mesh: a triangle
  std::array<Vec3, 3> corners{};                           // for a triangle only
  Pose pose = Pose::Identity();                            // for any other shape
  Vec3 half = Vec3::Zero();

  static ConvexShape ofSolid(const CollisionPiece& piece, const Pose& pose);
  static ConvexShape ofTriangle(const Vec3& a, const Vec3& b, const Vec3& c) { return {.corners = {a, b, c}}; }

  Vec3 centre() const;
  // Returns the point of the shape that is farthest in a direction, which need not have unit length.
  Vec3 support(const Vec3& direction) const;
};

// The closest points of two convex shapes.
struct ConvexNearest {
  double distance = 0.0;  // mm; 0: the shapes intersect or touch, and the points are meaningless
  Vec3 first = Vec3::Zero(), second = Vec3::Zero();
};

// Finds the closest points by the algorithm of Gilbert, Johnson and Keerthi (1988). The distance is never too large: a
// plane between the shapes proves it. The points may be a little farther apart. It may stop early if the distance
// is at least `enough`; the result is then a lower bound of at least `enough`, without points. Allocates nothing.
ConvexNearest nearestOf(const ConvexShape& a, const ConvexShape& b, double enough);

}  // namespace handwheel
