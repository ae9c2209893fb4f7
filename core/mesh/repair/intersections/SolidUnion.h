// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <cstddef>

namespace handwheel {

// Unites the solids that intersect or lie inside each other. Their faces are cut along each other, and the walls inside
// the union are removed (uniteAtWalls()), as are solids inside others that they do not touch (findNestedBodies());
// cavities stay. The outside is unchanged, to the last digit of the number type. The mesh is unchanged if no solid
// overlaps another, because surfaces are open or bodies inside out; if the result would intersect itself or have more
// edges without two faces; and if cancelled. Returns the number of removed pieces of walls and solids, 0 if nothing was
// changed. O(n) for the mesh and O(m log m) for m intersections, and O(n) for each wall.
std::size_t uniteSolids(HalfEdgeMesh& mesh, NumberType numbers, Progress progress = {});

}  // namespace handwheel
