// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"
#include "volume/SparseVolume.h"

#include <vector>

namespace handwheel {

// The surface of a volume by marching cubes (MarchingCubesTable). The triangles go through the cells of its samples and
// share points. Closed, manifold, oriented and free of self-intersections, as long as the coordinates tell voxels apart
// by a thousandth. O(blocks), on all threads of the arena; the same for any number of them. Empty when cancelled.
TriangleSoup surfaceOf(const SparseVolume& volume, Progress progress = {});
// The blocks in whose cells the surface can be: those with samples, and those whose high sides touch them.
std::vector<VoxelIndex> blocksWithCells(const SparseVolume& volume);

}  // namespace handwheel
