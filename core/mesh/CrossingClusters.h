// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Tolerance.h"
#include "mesh/HalfEdgeMesh.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace handwheel {

// Faces that cross others, taken together where the crossings hang together: pairs that share a face are of one
// cluster. Each sorted, in order of their first face. O(n log n).
std::vector<std::vector<Face>> crossingClusters(const std::vector<std::pair<Face, Face>>& pairs);

// Uncrosses (uncross()) each of these pairs of crossing faces and whatever crosses them, if that leaves none of a
// cluster's crossings, makes no new one and opens no edge; other clusters stay as they are. All are tried together,
// then by halves. Returns how many clusters are uncrossed. Takes no more than tolerance::kHardHoleEffort, nor than the
// effort of the progress: the other clusters stay as they are. O(n) for the mesh in each trial; one where all goes
// well. Once somebody cancelled it, the mesh is not to be used.
std::size_t uncrossClusters(HalfEdgeMesh& mesh, const std::vector<std::pair<Face, Face>>& pairs, NumberType numbers,
                            Progress progress = {});

}  // namespace handwheel
