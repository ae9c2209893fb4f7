// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/repair/intersections/SolidSubtraction.h"
#include "mesh/structure/TriangleSoup.h"
#include "volume/HybridPart.h"
#include "volume/drilling/DrillRecord.h"

namespace handwheel {

// Returns the surface of the region that a head swept, near the cut blocks. Outside the part it ends arbitrarily, seven
// voxels or more from the nearest voxel of the part. Closed, manifold, oriented and free of self-intersections, as that
// of surfaceOf(). hole: the record of the hole, whose DrillSetup::erosion is infinite; it is replayed. Empty if nothing
// was cut; invalid if cancelled.
TriangleSoup surfaceOfSweep(const HybridPart& part, const DrillRecord& hole, Progress progress = {});

// The triangles of a part with a hole drilled in it.
struct DrilledTriangles : Subtraction {  // kept: without those that close holes of the part
  std::size_t closing = 0;               // number of triangles added to close holes of the part before it is cut
};

// Subtracts a drilled hole from the triangles that a part was made of: the result consists of the swept surface and of
// the unchanged triangles elsewhere. Previous holes of the surface are closed as for its voxels (closeBoundaries()). If
// the surfaces coincide, the subtraction is retried with the swept surface shifted by a thousandth of a voxel. hole: as
// above. Invalid if cancelled.
DrilledTriangles drilledTriangles(const TriangleSoup& triangles, const HybridPart& part, const DrillRecord& hole,
                                  NumberType numbers, Progress progress = {});

}  // namespace handwheel
