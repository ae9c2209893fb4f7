// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/boundary/BoundaryVertices.h"
#include "mesh/structure/PositionKey.h"

namespace handwheel {

// Open edges that become one when near vertices are merged.
struct ClosingEdge {
  std::vector<std::size_t> pairs;      // indices of the pairs to merge for it, ascending
  std::vector<PointKey> endPositions;  // positions of the ends of the open edges
};

// Finds the edges that close when the second vertex of each pair moves onto the first. A pair that closes no edge only
// touches (two parts that meet in a vertex or were separated at a vertex), or consists of the two ends of a short
// border edge. Shrinking such an edge to a point would move the surface, perhaps across nearby faces, and join nothing.
// pairs must come from nearBoundaryVertices(). O(n log n) for the border. The result is invalid if cancelled.
std::vector<ClosingEdge> closingEdges(const HalfEdgeMesh& mesh, const VertexPairs& pairs, Progress progress = {});

// Returns the pairs that at least one of the edges needs.
VertexPairs closingPairs(const VertexPairs& pairs, const std::vector<ClosingEdge>& edges);

// Extends chosen pairs so that each closes an edge. A pair that closes no edge alone is completed by the other pairs of
// one of its edges.
VertexPairs withPartners(const VertexPairs& chosen, const VertexPairs& pairs, const std::vector<ClosingEdge>& edges);

// Groups edges that share pairs into connected runs. In a run, each edge after the first is connected with an earlier
// one. Edges that can only close together are in one run. pairs: the number of all pairs.
std::vector<std::vector<ClosingEdge>> connectedRuns(std::vector<ClosingEdge> edges, std::size_t pairs);

}  // namespace handwheel
