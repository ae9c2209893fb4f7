// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <vector>

namespace handwheel {

// Moves the free points so that the surface bends least: they minimise Σ |Δx|² / area over the free vertices and those
// next to them whose fan of triangles is closed, with the cotangent Laplacian and the Voronoi areas of the given shape
// (Botsch and Kobbelt, "An intuitive framework for real-time freeform modeling", 2004; Botsch et al. 2008). So the
// surface continues the tangents of fixed neighbours, and ends without a tangent of its own at a border of the
// triangles. The triangles are a manifold. False, and nothing moved, when a shape has no such surface (a fan without
// area, a free vertex that hangs on nothing). One sparse Cholesky factor: about O(n^1.5) for n free points.
bool fair(std::vector<Vec3>& points, const std::vector<Triangle>& triangles, const std::vector<bool>& isFree);

}  // namespace handwheel
