// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/CollisionBody.h"

namespace handwheel {

// A convex shape: a triangle, or the core of a rounded solid. The rounding radius is left to the caller, so that a
// sphere is a point. All shapes are in one frame, mm.
struct ConvexShape {
  CollisionPiece::Kind kind = CollisionPiece::Kind::Mesh;  // Mesh: a triangle
  std::array<Vec3, 3> corners{};                           // corners of a triangle
  Pose pose = Pose::Identity();                            // pose of any other shape
  Vec3 half = Vec3::Zero();

  static ConvexShape ofSolid(const CollisionPiece& piece, const Pose& pose);
  static ConvexShape ofTriangle(const Vec3& a, const Vec3& b, const Vec3& c) { return {.corners = {a, b, c}}; }

  Vec3 centre() const;
  // Returns a point of it that is farthest in that direction, which need not have unit length.
  Vec3 support(const Vec3& direction) const;
};

// The closest points of two convex shapes.
struct ConvexNearest {
  double distance = 0.0;  // mm; 0: they meet, and the points are meaningless
  Vec3 first = Vec3::Zero(), second = Vec3::Zero();
};

// Finds the closest points by the algorithm of Gilbert, Johnson and Keerthi (1988). It may stop early at `enough`: the
// distance is then a lower bound that is not below it, without points. Allocates nothing.
ConvexNearest nearestOf(const ConvexShape& a, const ConvexShape& b, double enough);

}  // namespace handwheel
