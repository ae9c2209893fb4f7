// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <span>

namespace handwheel {

// The half-space normal·y >= least; the normal has length 1.
struct HalfSpace {
  Vec3 normal = Vec3::UnitZ();
  double least = 0.0;
};

// The point nearest to the goal in the intersection of the half-spaces, each of which it may miss by the slack. All
// sets of up to three planes are tried: what presses a point against n planes is carried by three of them
// (Caratheodory), so that no plane met earlier can hold it where it would slide on. None fits where they leave no room:
// then the point that misses them least. O(n³) at worst, a comparison or two for one or two planes; neither allocates
// nor locks.
Vec3 nearestInCone(const Vec3& goal, std::span<const HalfSpace> planes, double slack);

}  // namespace handwheel
