// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/CollisionBody.h"

namespace handwheel {

// Returns the distance of two pieces, or a lower bound of it, mm. The result is the distance if that is below `enough`;
// otherwise it is at least `enough`. poseA, poseB: the poses of the pieces in the world.
double pieceDistance(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b, const Pose& poseB,
                     double enough);

// Returns the distance (mm) of a point from the surface of a box, cylinder or sphere around the origin; it is below 0
// inside.
double distanceFromSolid(CollisionPiece::Kind kind, const Vec3& half, const Vec3& p);

}  // namespace handwheel
