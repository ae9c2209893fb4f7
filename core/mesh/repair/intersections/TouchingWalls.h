// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"
#include "proximity/SelfIntersection.h"

#include <vector>

namespace handwheel {

// Finds pairs (i < j) of triangles that face each other and touch except for rounding. Their planes, seen from the
// larger triangle, coincide up to a few units in the last place, and the triangles overlap there. Where two boxes were
// rotated together, rounding decides whether their common wall has intersections or a gap; both are found. Sorted.
// O(n log n). The result is invalid if cancelled.
std::vector<TrianglePair> findTouchingWalls(const TriangleSoup& soup, Progress progress = {});

}  // namespace handwheel
