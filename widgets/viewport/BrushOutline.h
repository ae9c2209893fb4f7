// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/Picking.h"

namespace handwheel {

// Projects the circle of a brush onto the surface. Returns the points of a closed line, at most the radius above or
// below the tangent plane of the surface at the centre. If the line would jump from one part to another, the result is
// a plane circle in the tangent plane. If there is no surface, or it is not yet searchable, the result is a circle with
// the normal `towards`. Cost: one ray for each point, at most a millisecond.
std::vector<Vec3> brushOutline(const Pickable& pickable, const BrushCircle& brush, const Vec3& towards);

}  // namespace handwheel
