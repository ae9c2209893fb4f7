// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Tolerance.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace handwheel {

// Groups self-intersecting faces into clusters of connected pairs. Pairs that share a face are of one cluster. Each is
// sorted, in order of their first face. O(n log n).
std::vector<std::vector<Face>> intersectionClusters(const std::vector<std::pair<Face, Face>>& pairs);

// What removeClusterIntersections() did.
struct ClusterRemoval {
  std::size_t clusters = 0;  // that were resolved
  bool isCutShort = false;   // a trial of one took too much effort, or there was none left for it
};

// Removes self-intersections cluster by cluster, starting from pairs of intersecting faces. For each of these pairs and
// whatever intersects them, removeAllSelfIntersections() is kept if it leaves none of a cluster's intersections, makes
// no new one and opens no edge; other clusters stay as they are. All are tried together, then by halves. Takes no more
// than the effort of the progress, and each trial, unless there is but one cluster, no more than a quarter of what is
// left of it: the other clusters stay as they are. O(n) for the mesh in each trial; one where all goes well. The mesh
// is invalid if the user cancelled.
ClusterRemoval removeClusterIntersections(HalfEdgeMesh& mesh, const std::vector<std::pair<Face, Face>>& pairs,
                                          NumberType numbers, Progress progress = {});

}  // namespace handwheel
