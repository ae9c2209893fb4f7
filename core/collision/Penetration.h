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

// The penetration of the first shapes into the second. Moving the first shapes along the normal by the depth separates
// them.
struct Penetration {
  double depth = 0.0;           // mm
  Vec3 normal = Vec3::UnitZ();  // unit length
  Vec3 deepest = Vec3::Zero();  // the point of the first shapes that is deepest in the second ones
};

// Returns the penetration along a direction of unit length.
Penetration penetrationAlong(const std::vector<IntersectingShapes>& shapes, const Vec3& direction);

// Returns the smallest penetration over a set of directions. These are the normals of the shapes' faces; for solids
// also the cross products of their axes and the directions between their centres; and `last`, the direction in which
// the shapes were last apart, if it is not zero. isFirstClosed, isSecondClosed: the triangles are those of a closed
// mesh, so that only outward directions are tried. The list of shapes must not be empty.
Penetration minimumPenetration(const std::vector<IntersectingShapes>& shapes, const Vec3& last, bool isFirstClosed,
                               bool isSecondClosed);

// The surface point of a solid nearest to a given point, with the surface normal, in the frame of the solid.
struct SolidNearest {
  double distance;  // mm; below 0 inside
  Vec3 point, normal;
};
SolidNearest nearestOfSolid(CollisionPiece::Kind kind, const Vec3& half, const Vec3& p);

}  // namespace handwheel
