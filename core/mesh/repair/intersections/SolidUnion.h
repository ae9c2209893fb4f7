// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <cstddef>

namespace handwheel {

// Unites the solids that intersect or lie inside each other.
//
// Their faces are cut along each other, and the walls inside the union are removed (uniteAtWalls()), and so are solids
// inside others that they do not touch (findNestedBodies()); cavities stay. What was outside stays where it was, to the
// last digit of these numbers. The mesh is left as it was where no solid is inside another, even in part, because
// surfaces are open, or bodies inside out; where the result would intersect itself, or have more edges without two
// faces; and if cancelled. Returns how many pieces of walls and solids were removed, 0 where nothing was changed. Needs
// O(n) for the mesh beside O(m log m) for m intersections, and O(n) for each wall.
std::size_t uniteSolids(HalfEdgeMesh& mesh, NumberType numbers, Progress progress = {});

}  // namespace handwheel
