// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <cstddef>

namespace handwheel {

// Unites the solids that intersect or lie inside each other. Their faces are cut along the intersections, and the walls
// inside the union are removed (uniteAtWalls()). Solids inside others that they do not touch are removed as well
// (findNestedBodies()); cavities stay. The outer surface keeps its position, up to rounding in the last digit of the
// number type. The mesh is left unchanged if no solid overlaps another, if open surfaces or inside-out bodies leave it
// undecided which walls are inside, if the result would intersect itself or have more edges without two faces than
// before, and if cancelled. Returns the number of removed pieces of walls and solids, 0 if nothing was changed. O(n)
// for the mesh and O(m log m) for m intersections, and O(n) for each wall.
std::size_t uniteSolids(HalfEdgeMesh& mesh, NumberType numbers, Progress progress = {});

}  // namespace handwheel
