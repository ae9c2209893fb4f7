// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/ConvexDistance.h"

#include <vector>

namespace handwheel {

// Two convex shapes that intersect, in one frame.
struct IntersectingShapes {
  ConvexShape first, second;
};

// The depth to which shapes penetrate others. Moved along the normal by the depth, the first ones are apart.
struct Penetration {
  double depth = 0.0;           // mm
  Vec3 normal = Vec3::UnitZ();  // unit length
  Vec3 deepest = Vec3::Zero();  // the point of the first shapes that is deepest in the second ones
};

// Returns the penetration along a direction of unit length.
Penetration penetrationAlong(const std::vector<IntersectingShapes>& shapes, const Vec3& direction);

// Returns the smallest penetration along the normals of the shapes' faces and, for solids, along their edges and the
// directions between; and along `last`, the direction in which they were apart, if it is not zero. isFirstClosed,
// isSecondClosed: their triangles have an outside, so only outward directions are tried. The shapes must not be empty.
Penetration minimumPenetration(const std::vector<IntersectingShapes>& shapes, const Vec3& last, bool isFirstClosed,
                               bool isSecondClosed);

// The point of a solid's surface nearest to a point, and the surface normal there, in the frame of the solid.
struct SolidNearest {
  double distance;  // mm; below 0 inside
  Vec3 point, normal;
};
SolidNearest nearestOfSolid(CollisionPiece::Kind kind, const Vec3& half, const Vec3& p);

}  // namespace handwheel
