// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/ClosingEdges.h"

namespace handwheel {

// Merges pairs of near vertices where that closes open edges. No edge gets more than two faces. Edges that can only be
// closed together are merged together; if a run of edges cannot be closed as a whole, its halves are tried. Only the
// faces at these vertices are examined. O(m log m) for m such faces. Faces that shrink to an edge are removed. The
// caller must relink the mesh. pairs must come from nearBoundaryVertices(). Returns the vertices that were moved. If
// cancelled, some pairs may remain.
std::vector<Vertex> mergeClosingPairs(HalfEdgeMesh& mesh, const VertexPairs& pairs, Progress progress = {});

}  // namespace handwheel
