// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/repair/intersections/SolidSubtraction.h"
#include "mesh/structure/TriangleSoup.h"
#include "volume/HybridPart.h"
#include "volume/drilling/DrillRecord.h"

namespace handwheel {

// Returns the surface of the region that a head swept, near the cut blocks. It ends arbitrarily outside the part, seven
// voxels or more from the nearest voxel of the part. Like the result of surfaceOf(), it is closed, manifold, oriented
// and free of self-intersections. hole: record of the hole, whose DrillSetup::erosion must be infinite; it is replayed.
// The result is empty if nothing was cut, and invalid if cancelled.
TriangleSoup surfaceOfSweep(const HybridPart& part, const DrillRecord& hole, Progress progress = {});

// The triangles of a part with a hole drilled in it.
struct DrilledTriangles : Subtraction {  // `kept` excludes triangles that close holes of the part
  std::size_t closing = 0;               // number of triangles that close holes of the part before it is cut
};

// Subtracts a drilled hole from the triangles of which a part was made. The result consists of the swept surface and of
// the other triangles, unchanged. Previous holes of the surface are closed as for its voxels (closeBoundaries()). If
// the surfaces coincide, the subtraction is repeated with the swept surface shifted by a thousandth of a voxel. hole:
// see surfaceOfSweep(). The result is invalid if cancelled.
DrilledTriangles drilledTriangles(const TriangleSoup& triangles, const HybridPart& part, const DrillRecord& hole,
                                  NumberType numbers, Progress progress = {});

}  // namespace handwheel
