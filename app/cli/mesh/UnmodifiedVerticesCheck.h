// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

#include <vector>

namespace handwheel {

// Returns true if all vertices that a repair did not modify are bitwise unchanged. Each vertex of "before" (already
// rounded to the number type of the file) that is not in "modified" must be found in the written file with the same
// bits. Vertices that only removed faces used may be missing. O(n).
bool unmodifiedAreIdentical(const HalfEdgeMesh& before, const HalfEdgeMesh& after, const std::vector<Vertex>& modified,
                            const TriangleSoup& written);

}  // namespace handwheel
