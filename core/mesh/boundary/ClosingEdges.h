// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/boundary/BoundaryVertices.h"
#include "mesh/structure/PositionKey.h"

namespace handwheel {

// Open edges that become one when near vertices are merged.
struct ClosingEdge {
  std::vector<std::size_t> pairs;  // that have to be merged for it, by index, rising
  std::vector<PointKey> places;    // of the ends of the open edges
};

// The edges that close when the second vertex of each pair moves onto the first. A pair that is in none of them only
// touches (two parts that meet in a vertex, or that were separated there), or is the two ends of a short border edge.
// Shrinking that edge to a point would move the surface, perhaps across what lies beside it, and join nothing. pairs:
// as nearBoundaryVertices() returns them. O(n log n) for the border. The result is invalid if cancelled.
std::vector<ClosingEdge> closingEdges(const HalfEdgeMesh& mesh, const VertexPairs& pairs, Progress progress = {});

// The pairs that are in one of these edges.
VertexPairs closingPairs(const VertexPairs& pairs, const std::vector<ClosingEdge>& edges);

// These pairs, and with each that closes no edge without others those of one edge that they close together.
VertexPairs withPartners(const VertexPairs& chosen, const VertexPairs& pairs, const std::vector<ClosingEdge>& edges);

// The edges in connected runs: those that share a pair, each next to one that is before it. What closes only together
// is in one run.
std::vector<std::vector<ClosingEdge>> connectedRuns(std::vector<ClosingEdge> edges, std::size_t pairs);

}  // namespace handwheel
