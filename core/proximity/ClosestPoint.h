// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

namespace handwheel {

// Returns the point of the segment nearest to p. The segment may be a point.
Vec3 closestOnSegment(const Vec3& p, const Vec3& a, const Vec3& b);

// Returns the point of the triangle nearest to p. The triangle may be a segment or a point; for a needle the error is
// at most its width.
Vec3 closestOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace handwheel
