// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/TriangleSoup.h"
#include "nurbs/StockCylinder.h"

namespace handwheel {

// How far triangles are at most from the surface of a cylinder, ends included (mm): in closed form, measured on the
// triangles and not derived from how they were made. Exact where every triangle belongs to the mantle or to one end,
// else an upper bound. O(triangles).
double distanceToCylinder(const TriangleSoup& soup, const StockCylinder& cylinder);

}  // namespace handwheel
