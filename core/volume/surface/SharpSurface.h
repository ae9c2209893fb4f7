// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"
#include "volume/SparseVolume.h"

namespace handwheel {

// Returns the surface of a volume with its sharp edges (extended marching cubes). The surface is that of surfaceOf(),
// except in cells with an edge or corner (SharpFeature). There the polygon becomes a fan around a point on the feature,
// and these points are joined across the faces of cells (Kobbelt et al., "Feature sensitive surface extraction", 2001).
// So the surface is closed, manifold and oriented by construction. Cells whose triangles would intersect others keep
// the polygons of marching cubes, so that the surface is free of self-intersections, even with coordinates rounded to
// single precision. Takes a few passes of O(n log n) on all threads of the arena. The result is empty if cancelled.
TriangleSoup sharpSurfaceOf(const SparseVolume& volume, Progress progress = {});

}  // namespace handwheel
