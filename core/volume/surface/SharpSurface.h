// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"
#include "volume/SparseVolume.h"

namespace handwheel {

// The surface of a volume with its sharp edges (extended marching cubes). It is that of surfaceOf(), but in cells with
// an edge or corner (SharpFeature) the polygon becomes a fan around a point on it, and such points are joined across
// the faces of cells (Kobbelt et al., "Feature sensitive surface extraction", 2001). So it stays closed, manifold and
// oriented by construction. Where triangles would meet others, their cells keep the polygons of marching cubes: free of
// self-intersections, as those are, also where coordinates are rounded to single precision. O(n log n) some times, on
// all threads of the arena. Empty when cancelled.
TriangleSoup sharpSurfaceOf(const SparseVolume& volume, Progress progress = {});

}  // namespace handwheel
