// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryVertices.h"

namespace handwheel {

// Stitches borders that were separated by rounding or cutting in the file. Merges border vertices where that closes
// open edges (mergeClosingPairs()), then splits border edges at border vertices that lie on them within the same
// distance (T-junctions), and merges the edges that close then. Vertices in "fixed" are ignored. Changes are kept only
// if fewer border edges and no more non-manifold edges result; then the mesh is relinked. The whole mesh is linked at
// most three times. Returns the vertices that were moved onto another one. If cancelled, some may remain.
std::vector<Vertex> stitchBoundaries(HalfEdgeMesh& mesh, const std::vector<bool>& fixed, Progress progress = {},
                                     double nearWeld = tolerance::kNearWeld);

// Finds the near vertices that stitchBoundaries() may merge. These are the pairs that close an open edge with others,
// also after border edges are split at the vertices on them. The other pairs only touch, or bound a short edge, which
// is no defect. The result is invalid if cancelled.
VertexPairs stitchablePairs(const HalfEdgeMesh& mesh, double nearWeld = tolerance::kNearWeld, Progress progress = {});

// Marks the vertices to be fixed so that only the chosen pairs are merged. Pairs that close an edge together with a
// chosen one are merged too.
std::vector<bool> fixedBut(const HalfEdgeMesh& mesh, const VertexPairs& chosen, double nearWeld,
                           Progress progress = {});

}  // namespace handwheel
