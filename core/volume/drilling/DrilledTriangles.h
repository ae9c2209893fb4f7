// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/repair/intersections/SolidSubtraction.h"
#include "mesh/structure/TriangleSoup.h"
#include "volume/HybridPart.h"
#include "volume/drilling/DrillRecord.h"

namespace handwheel {

// The surface of what a head went through, near the blocks that it cut. Outside the part it ends anywhere, seven voxels
// or more from the nearest voxel of it. Closed, manifold, oriented and free of self-intersections, as that of
// surfaceOf(). hole: how the part was drilled, by a head that takes all that is in it (DrillSetup::erosion is
// infinite). It is gone through once more. Empty where nothing was cut; invalid if cancelled.
TriangleSoup surfaceOfSweep(const HybridPart& part, const DrillRecord& hole, Progress progress = {});

// The triangles of a part with a hole drilled in it.
struct DrilledTriangles : Subtraction {  // kept: without those that close holes of the part
  std::size_t closing = 0;               // triangles that were added to close holes that the part had, before it is cut
};

// The triangles that a part was made of, with the hole that was drilled in it: where the head was, its surface, and
// elsewhere the triangles as they are. Holes that the part had before are closed as they are for its voxels
// (closeBoundaries()). Where the surfaces lie on each other, that of the head is tried again a thousandth of a voxel
// aside. hole: as above. Invalid if cancelled.
DrilledTriangles drilledTriangles(const TriangleSoup& triangles, const HybridPart& part, const DrillRecord& hole,
                                  NumberType numbers, Progress progress = {});

}  // namespace handwheel
