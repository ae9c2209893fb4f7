// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"
#include "nurbs/StockCylinder.h"

namespace handwheel {

// Returns the largest distance of triangles from the surface of a cylinder, mm. The surface includes the ends. The
// distance is computed in closed form from the triangles, independently of the tessellation. It is exact if every
// triangle belongs to the lateral surface or to one end, and an upper bound otherwise. O(triangles).
double distanceToCylinder(const TriangleSoup& soup, const StockCylinder& cylinder);

}  // namespace handwheel
