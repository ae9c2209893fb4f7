// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

namespace handwheel {

// Returns the distance (mm) by which rounding may separate two copies of a point. If all coordinates fit into floats,
// each is exact to half a unit in the last place of the largest coordinate of its axis. Otherwise the number of
// decimals of the file is found, for example 3 for survey coordinates like 5400000.125. Decimals count only if they are
// small compared to the model: at most 1e-4 of its diagonal, or 1e-3 if it lies far from the origin; a part drawn on a
// coarse grid is not rounded to it. A vertex on an edge deviates from the line through the ends of the edge by no more
// than this either. 0 if coordinates have all digits of a double. O(n).
double coordinateRounding(const HalfEdgeMesh& mesh);

}  // namespace handwheel
