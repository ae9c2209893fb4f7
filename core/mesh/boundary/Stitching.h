// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Tolerance.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <vector>

namespace handwheel {

// Stitches borders that were separated by rounding or cutting in the file. Merges border vertices as
// nearBorderVertices() pairs them, then splits border edges at border vertices that lie on them within the same
// distance (T-junctions). Vertices in "fixed" are ignored. Changes are kept only when fewer border edges and no more
// non-manifold edges result; then the mesh is relinked. Where that does not hold for all pairs together, it is tried
// with closingPairs() only, and with ever fewer of these, a limited number of times. Returns the vertices that were
// moved onto another one. When cancelled, some may be left.
std::vector<Vertex> stitchBorders(HalfEdgeMesh& mesh, const std::vector<bool>& fixed, Progress progress = {},
                                  double nearWeld = tolerance::kNearWeld);

}  // namespace handwheel
