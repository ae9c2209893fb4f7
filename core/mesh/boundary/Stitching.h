// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryVertices.h"

namespace handwheel {

// Stitches borders that were separated by rounding or cutting in the file. Merges border vertices where that closes
// open edges (mergeClosingPairs()), then splits border edges at border vertices that lie on them within the same
// distance (T-junctions), and merges what closes then. Vertices in "fixed" are ignored. Changes are kept only when
// fewer border edges and no more non-manifold edges result; then the mesh is relinked. At most three times the whole
// mesh is linked, however much may not be merged. Returns the vertices that were moved onto another one. When
// cancelled, some may be left.
std::vector<Vertex> stitchBoundaries(HalfEdgeMesh& mesh, const std::vector<bool>& fixed, Progress progress = {},
                                     double nearWeld = tolerance::kNearWeld);

// The near vertices that stitchBoundaries() may merge: those that close an open edge with others, also once border
// edges are split at the vertices on them. The rest only touches, or bounds a short edge, which is no defect. The
// result is invalid if cancelled.
VertexPairs stitchablePairs(const HalfEdgeMesh& mesh, double nearWeld = tolerance::kNearWeld, Progress progress = {});

// The vertices to be fixed where only these pairs are to be merged, and what closes an edge only together with them.
std::vector<bool> fixedBut(const HalfEdgeMesh& mesh, const VertexPairs& chosen, double nearWeld,
                           Progress progress = {});

}  // namespace handwheel
