// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"
#include "nurbs/StockCylinder.h"

namespace handwheel {

// Returns the largest distance of triangles from the surface of a cylinder, ends included (mm). In closed form,
// measured on the triangles, independently of the tessellation. Exact if every triangle belongs to the lateral surface
// or to one end, else an upper bound. O(triangles).
double distanceToCylinder(const TriangleSoup& soup, const StockCylinder& cylinder);

}  // namespace handwheel
