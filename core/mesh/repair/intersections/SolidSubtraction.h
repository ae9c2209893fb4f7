// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"
#include "mesh/structure/TriangleSoup.h"

#include <cstddef>

namespace handwheel {

// Why a solid was not subtracted from another.
enum class SubtractionProblem {
  None,
  NotClosed,             // the part has open, non-manifold or inconsistent edges, or touches itself at a vertex
  IntersectsItself,      // the part does
  TooManyIntersections,  // it would take minutes
  Unsound,               // the result would not be closed, manifold and free of self-intersections
};

// The result of subtractSolid().
struct Subtraction {
  HalfEdgeMesh mesh;  // empty where nothing is left, and where there is a problem
  SubtractionProblem problem = SubtractionProblem::None;
  std::size_t kept = 0;  // triangles that are those of the part; they are the first faces
};

// Subtracts a solid from another by their surfaces. Their triangles are cut along each other (autorefine()), and what
// hangs together between the cuts stays or goes by the winding number of the other surface there: of the part what is
// outside the tool, of the tool what is inside the part, turned over. So triangles that the tool does not meet stay as
// they are, to the last digit of these numbers. The result is checked: closed, manifold, without self-intersections, as
// a file of these numbers stores it. Where surfaces lie on each other, or rounding folds a piece, it is Unsound. Needs
// O(n log n) beside O(m log m) for m intersections, and O(n) for each of the parts that they cut the surfaces into.
// Invalid if cancelled.
Subtraction subtractSolid(const TriangleSoup& part, const TriangleSoup& tool, NumberType numbers,
                          Progress progress = {});

}  // namespace handwheel
