// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/CollisionBody.h"

namespace handwheel {

// Returns the distance of two pieces (mm), or a lower bound once it reaches `enough`. The bound is not below `enough`.
// Poses: of their frames in the world.
double pieceDistance(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b, const Pose& poseB,
                     double enough);

// Returns the distance of a point from a solid box, cylinder or sphere around the origin; below 0 inside. mm.
double distanceFromSolid(CollisionPiece::Kind kind, const Vec3& half, const Vec3& p);

}  // namespace handwheel
