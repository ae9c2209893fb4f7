// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

namespace handwheel {

using TrianglePoints = std::array<Vec3, 3>;

// Returns true if two triangles intersect in more than a shared vertex or edge. Touching counts. Corners are shared if
// their positions are equal. A doubled triangle and a fold lying flat on its neighbour count. The test is exact (CGAL's
// exact predicates are used if floating point is inconclusive) and thread-safe. Both triangles must have area and
// finite coordinates.
bool trianglesMeet(const TrianglePoints& a, const TrianglePoints& b);

// Returns true if a triangle has exactly zero area: two equal corners or all three on one line. The coordinates must be
// finite.
bool isDegenerate(const TrianglePoints& t);

}  // namespace handwheel
