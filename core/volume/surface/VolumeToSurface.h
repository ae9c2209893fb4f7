// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"
#include "volume/SparseVolume.h"

#include <vector>

namespace handwheel {

// Returns the surface of a volume by marching cubes (MarchingCubesTable). The triangles share points. The surface is
// closed, manifold, oriented and free of self-intersections, as long as the coordinates resolve a thousandth of a
// voxel. Runs on all threads of the arena; the result does not depend on their number. O(blocks). The result is empty
// if cancelled.
TriangleSoup surfaceOf(const SparseVolume& volume, Progress progress = {});
// Returns the blocks with cells that the surface may cross. These are the blocks with samples, and the blocks that
// touch them at their upper sides.
std::vector<VoxelIndex> blocksWithCells(const SparseVolume& volume);

}  // namespace handwheel
