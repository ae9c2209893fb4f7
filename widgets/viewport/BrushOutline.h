// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/Picking.h"

namespace handwheel {

// Projects the circle of a brush onto the surface. Returns a closed line of points, at most radius above or below the
// tangent plane of the surface at the centre. When the line would jump from one part to another, it is a plain circle
// in that plane; when there is no surface, or it is not yet searchable, a circle with the normal `towards`. At
// most a millisecond: one ray for each point.
std::vector<Vec3> brushOutline(const Pickable& pickable, const BrushCircle& brush, const Vec3& towards);

}  // namespace handwheel
