// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <vector>

namespace handwheel {

// How smoothly a faired surface continues its fixed neighbours.
enum class Continuity {
  Position,   // it meets them: a membrane, of least area as far as its start tells
  Tangent,    // and has their tangents: a thin plate that bends least
  Curvature,  // and their curvature: its bending varies least
};

// Moves the free points so that the surface has the least energy: of order 1, Σ |∇x|² over the triangles; of order 2,
// Σ |Δx|² · area over the vertices; of order 3, Σ |∇Δx|² over the triangles, for position, tangent and curvature
// (Botsch and Kobbelt, "An intuitive framework for real-time freeform modeling", 2004, section 4; Botsch et al. 2008).
// Δ is the cotangent Laplacian of the given shape over its Voronoi areas, known where the fan of triangles is closed;
// so the surface ends without a tangent of its own at a border of the triangles. As many rings of triangles around the
// free points count as the order says. The triangles are a manifold. False, and nothing moved, when a shape has no such
// surface (a fan without area, a free vertex that hangs on nothing) or the numbers are too short for it. One sparse
// Cholesky factor: about O(n^1.5) for n free points, of a matrix with some 7, 19 and 37 entries in a row.
bool fair(std::vector<Vec3>& points, const std::vector<Triangle>& triangles, const std::vector<bool>& isFree,
          Continuity continuity = Continuity::Tangent);

}  // namespace handwheel
