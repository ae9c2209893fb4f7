// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <cstddef>

namespace handwheel {

// The result of uniteSolids().
struct SolidUnion {
  bool changed = false;        // else the mesh is as it was
  std::size_t innerFaces = 0;  // pieces of walls inside the union that were removed
};

// Unites the solids that intersect: their faces are cut along each other, and the walls inside the union are removed
// (uniteAtWalls()). What was outside stays where it was, to the last digit of these numbers. A solid inside another
// that it does not touch stays, like a cavity. The mesh is left as it was where no solid is inside another in part,
// because surfaces are open, or bodies inside out; where the result would intersect itself, or have more edges without
// two faces; and if cancelled. Needs O(n) for the mesh beside O(m log m) for m intersections, and O(n) for each wall.
SolidUnion uniteSolids(HalfEdgeMesh& mesh, NumberType numbers, Progress progress = {});

}  // namespace handwheel
