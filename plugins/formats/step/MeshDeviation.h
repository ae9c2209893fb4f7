// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>

namespace handwheel {

// Estimates the largest distance of a shape's surfaces from its triangles, mm. It is measured from the plane of each
// triangle at four points: its centre and the midpoints of its sides. Faces without triangles, or without parameters at
// their corners, count as 0. The mesher of Open CASCADE observes its deflection along edges but may exceed it within
// faces, on a ball by a factor of slightly more than two. O(triangles).
double meshDeviation(const TopoDS_Shape& shape);

}  // namespace handwheel
