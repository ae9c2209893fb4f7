// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>

namespace handwheel {

// The largest distance of a shape's surfaces from its triangles (mm). It is measured over the centre of each triangle
// and the middles of its sides; faces without triangles, or without parameters at their corners, count as 0. The mesher
// of Open CASCADE keeps the deflection that it is asked for at edges, but within faces only about: on a ball the
// distance is up to twice that. O(triangles).
double meshDeviation(const TopoDS_Shape& shape);

}  // namespace handwheel
