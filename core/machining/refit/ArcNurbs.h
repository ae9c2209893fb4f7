// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/ProfileSegment.h"
#include "nurbs/ProfileCurve.h"

#include <span>

namespace handwheel {

// The exact rational curve of degree 2 over a chain of lines and circular arcs. Each of them begins at the end of the
// one before. Inner knots are double, so every joint is a pole and may be a sharp corner: the same as a double pole
// over single knots, with one pole less. Arcs are split where their tangent is parallel to an axis, so that no pole is
// outside of the box of its arc, nor across the axis of the part. O(segments).
ProfileNurbs nurbsOf(std::span<const ProfileSegment> segments);

}  // namespace handwheel
