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

// Groups self-intersecting faces into clusters of connected pairs. Pairs that share a face belong to one cluster. Each
// cluster is sorted, and clusters are in order of their first face. O(n log n).
std::vector<std::vector<Face>> intersectionClusters(const std::vector<std::pair<Face, Face>>& pairs);

// The result of removeClusterIntersections().
struct ClusterRemoval {
  std::size_t clusters = 0;  // number of resolved clusters
  bool isCutShort = false;   // a trial took too much effort, or no effort was left
};

// Removes self-intersections cluster by cluster, starting from pairs of intersecting faces. For these pairs and all
// faces that intersect them, the result of removeAllSelfIntersections() is kept if it leaves none of a cluster's
// intersections, makes no new one and opens no edge; other clusters stay as they are. All clusters are tried together,
// then in halves. The work is limited by the effort of the progress, and each trial, unless there is only one cluster,
// by a quarter of the remaining effort; clusters that exceed these limits stay as they are. Each trial costs O(n) for
// the mesh; one trial suffices if all clusters succeed. The mesh is invalid if the user cancelled.
ClusterRemoval removeClusterIntersections(HalfEdgeMesh& mesh, const std::vector<std::pair<Face, Face>>& pairs,
                                          NumberType numbers, Progress progress = {});

}  // namespace handwheel
