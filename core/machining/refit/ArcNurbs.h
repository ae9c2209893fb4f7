// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/ProfileSegment.h"
#include "nurbs/ProfileCurve.h"

#include <span>

namespace handwheel {

// Returns the exact rational curve of degree 2 over lines and circular arcs. Each of them begins at the end of the one
// before. Inner knots are double, so every joint is a pole and may be a sharp corner. Single knots with a double pole
// would give the same corner, but need one pole more. Arcs are split where their tangent is parallel to an axis, so
// that each pole is inside the box of its arc, and none is across the axis of the part. O(segments).
ProfileNurbs nurbsOf(std::span<const ProfileSegment> segments);

}  // namespace handwheel
