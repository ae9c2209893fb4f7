// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/Picking.h"

namespace handwheel {

// The brush's circle, laid on the surface around its centre as a closed line of points, at most radius above or below
// the surface's tangent plane. Where it would leap from one part to another, it is a plain circle in that plane; where
// there is no surface, and before the mesh is searchable, one that faces towards. At most a millisecond: a ray for each
// point.
std::vector<Vec3> brushOutline(const Pickable& pickable, const BrushCircle& brush, const Vec3& towards);

}  // namespace handwheel
