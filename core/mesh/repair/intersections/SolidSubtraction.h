// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"
#include "mesh/structure/TriangleSoup.h"

#include <cstddef>

namespace handwheel {

// The reason why a solid was not subtracted from another.
enum class SubtractionProblem {
  None,
  NotClosed,             // the part has open, non-manifold or inconsistent edges, or touches itself at a vertex
  IntersectsItself,      // the part intersects itself
  TooManyIntersections,  // the cut would take minutes
  Unsound,               // the result would not be closed, manifold and free of self-intersections
};

// The result of subtractSolid().
struct Subtraction {
  HalfEdgeMesh mesh;  // empty if nothing is left or there is a problem
  SubtractionProblem problem = SubtractionProblem::None;
  std::size_t kept = 0;  // number of unchanged triangles of the part, which are the first faces
};

// Subtracts a solid from another by their surfaces. Their triangles are cut along each other (autorefine()), and the
// winding number of the other surface decides for each connected region between the cuts: the regions of the part
// outside the tool stay, and the regions of the tool inside the part are added in reverse orientation. Triangles that
// the tool does not meet are unchanged, to the last digit of the number type. The result is verified to be closed,
// manifold and without self-intersections, as a file of this number type stores it. The problem is Unsound if surfaces
// coincide or rounding folds a piece. O(n log n) plus O(m log m) for m intersections, plus O(n) for each region between
// the cuts. The result is invalid if cancelled.
Subtraction subtractSolid(const TriangleSoup& part, const TriangleSoup& tool, NumberType numbers,
                          Progress progress = {});

}  // namespace handwheel
