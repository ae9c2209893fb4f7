// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Progress.h"
#include "mesh/holes/Patch.h"

#include <vector>

namespace handwheel {

// Fairs a surface by moving its free points to the least energy. The energy is Σ |∇x|² over the triangles (order 1) for
// Position, Σ |Δx|² · area over the vertices (order 2) for Tangent, and Σ |∇Δx|² over the triangles (order 3) for
// Curvature (Botsch and Kobbelt, "An intuitive framework for real-time freeform modeling", 2004, section 4; Botsch et
// al. 2008). Δ is the cotangent Laplacian of the given shape over its Voronoi areas. It is defined where the fan of
// triangles is closed, so the surface has no prescribed tangent at a border of the triangles. The number of rings of
// triangles used around the free points equals the order. The triangles must be manifold. Returns false, without moving
// a point, if there is no such surface (a fan without area, an unconnected free vertex), if the numerical precision
// does not suffice, or if cancelled. The cost is that of one sparse Cholesky factorisation, about O(n^1.5) for n free
// points. A row of the matrix has about 7, 19 or 37 entries for order 1, 2 or 3.
bool fair(std::vector<Vec3>& points, const std::vector<Triangle>& triangles, const std::vector<bool>& isFree,
          Continuity continuity = Continuity::Tangent, Progress progress = {});

}  // namespace handwheel
