// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryVertices.h"

namespace handwheel {

// Stitches borders that were separated by rounding or cutting in the file. The function merges border vertices where
// that closes open edges (mergeClosingPairs()). Then it splits border edges at near border vertices (T-junctions,
// splitTJunctions()), and merges the border vertices whose edges can be closed after the splits. Vertices marked in
// "fixed" are ignored. If fewer border edges and no more non-manifold edges result, the mesh is relinked; otherwise it
// is unchanged. The whole mesh is linked at most three times. Returns the vertices that were moved onto another one. If
// cancelled, some borders may stay open.
std::vector<Vertex> stitchBoundaries(HalfEdgeMesh& mesh, const std::vector<bool>& fixed, Progress progress = {},
                                     double nearWeld = tolerance::kNearWeld);

// Finds the pairs of near vertices that stitchBoundaries() may merge. Merging such a pair, alone or with others, closes
// an open edge, possibly after border edges are split at the vertices on them. All other pairs are no defects: their
// vertices only touch, or are the ends of a short edge. The result is invalid if cancelled.
VertexPairs stitchablePairs(const HalfEdgeMesh& mesh, double nearWeld = tolerance::kNearWeld, Progress progress = {});

// Marks the vertices that must be fixed so that stitchBoundaries() merges only the chosen pairs. Pairs that close an
// edge together with a chosen one are merged too.
std::vector<bool> fixedBut(const HalfEdgeMesh& mesh, const VertexPairs& chosen, double nearWeld,
                           Progress progress = {});

}  // namespace handwheel
