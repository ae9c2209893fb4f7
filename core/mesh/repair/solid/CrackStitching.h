// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

namespace handwheel {

// Stitches the cracks of a mesh. Cracks are stretches of boundaries that run along each other in opposite directions,
// at most the reach (mm) apart and at least ten times as long as that. The vertices of both sides meet in the middle.
// What remains open between them are small holes. Unlike for stitchBoundaries(), the gap may be as wide as the edges
// are long. Returns the vertices that were moved; the mesh is unchanged if none, or if cancelled. O(n log n).
std::vector<Vertex> stitchCracks(HalfEdgeMesh& mesh, double reach, Progress progress = {});

}  // namespace handwheel
