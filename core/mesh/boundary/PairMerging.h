// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/ClosingEdges.h"

namespace handwheel {

// Merges near vertices wherever that closes open edges. No edge gets more than two faces by it. What closes only
// together is merged together; a run of edges that must not be closed as a whole is tried by halves. Only the faces at
// these vertices are looked at, so that O(m log m) suffices for m of them, however many must not be merged. Faces that
// shrink to an edge are removed. The mesh must be relinked then. pairs: as nearBoundaryVertices() returns them. Returns
// the vertices that were moved. When cancelled, some may be left.
std::vector<Vertex> mergeClosingPairs(HalfEdgeMesh& mesh, const VertexPairs& pairs, Progress progress = {});

}  // namespace handwheel
