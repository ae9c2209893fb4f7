// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/ConvexDistance.h"

#include <vector>

namespace handwheel {

// Two convex shapes that meet, in one frame.
struct MeetingShapes {
  ConvexShape first, second;
};

// How to take shapes apart that meet: all of the first ones move along the normal by the depth.
struct WayOut {
  double depth = 0.0;           // mm
  Vec3 normal = Vec3::UnitZ();  // of unit length
  Vec3 deepest = Vec3::Zero();  // the point of the first ones that is deepest in the second
};

// The way out along that direction, which has unit length.
WayOut wayOutAlong(const std::vector<MeetingShapes>& shapes, const Vec3& direction);

// The least of those along the shapes' faces and, of solids, their edges and what lies between; and along `last`, the
// direction in which they were apart, if it is not zero. isFirstClosed, isSecondClosed: their triangles know an
// outside, into which alone the way leads. Not empty: the shapes.
WayOut leastWayOut(const std::vector<MeetingShapes>& shapes, const Vec3& last, bool isFirstClosed, bool isSecondClosed);

// The point of a solid's surface nearest to a point, and the way to leave it there, in the frame of the solid.
struct SolidNearest {
  double distance;  // mm; below 0 inside
  Vec3 point, normal;
};
SolidNearest nearestOfSolid(CollisionPiece::Kind kind, const Vec3& half, const Vec3& p);

}  // namespace handwheel
