// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Progress.h"

#include <vector>

namespace handwheel {

// The continuity between a faired surface and its fixed neighbours.
enum class Continuity {
  Position,   // equal positions: a membrane, of least area as far as its initial shape allows
  Tangent,    // also equal tangents: a thin plate of least bending
  Curvature,  // also equal curvature: least variation of bending
};

// Fairs a surface by moving its free points to the least energy. Of order 1 it is Σ |∇x|² over the triangles; of order
// 2, Σ |Δx|² · area over the vertices; of order 3, Σ |∇Δx|² over the triangles, for position, tangent and curvature
// (Botsch and Kobbelt, "An intuitive framework for real-time freeform modeling", 2004, section 4; Botsch et al. 2008).
// Δ is the cotangent Laplacian of the given shape over its Voronoi areas. It is defined where the fan of triangles is
// closed, so the surface has no prescribed tangent at a border of the triangles. The number of rings of triangles used
// around the free points equals the order. The triangles must be manifold. Returns false, without a move, if there is
// no such surface (a fan without area, an unconnected free vertex), if the numerical precision does not suffice, or if
// cancelled. One sparse Cholesky factor: about O(n^1.5) for n free points, of a matrix with some 7, 19 and 37 entries
// in a row.
bool fair(std::vector<Vec3>& points, const std::vector<Triangle>& triangles, const std::vector<bool>& isFree,
          Continuity continuity = Continuity::Tangent, Progress progress = {});

}  // namespace handwheel
