// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <span>

namespace handwheel {

// The half-space normal·y >= least, with a unit normal.
struct HalfSpace {
  Vec3 normal = Vec3::UnitZ();
  double least = 0.0;
};

// Projects a point onto the intersection of half-spaces. Returns the point of the intersection that is nearest to the
// goal; it may violate each half-space by the slack. All sets of up to three planes are tried: three of n planes
// suffice to balance the force that presses a point against them (Caratheodory), so that no plane that was hit earlier
// can stop a point that should slide on. If the intersection is empty, the function returns the point that violates the
// half-spaces least. O(n³) at worst; one or two planes take only a few comparisons. The function neither allocates nor
// locks.
Vec3 nearestInCone(const Vec3& goal, std::span<const HalfSpace> planes, double slack);

}  // namespace handwheel
