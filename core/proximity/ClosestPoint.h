// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

namespace handwheel {

// The point of the segment nearest to p. The segment may be a point.
Vec3 closestOnSegment(const Vec3& p, const Vec3& a, const Vec3& b);

// The point of the triangle nearest to p. The triangle may be a segment or a point; a needle's point is off by no more
// than its width.
Vec3 closestOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace handwheel
