// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

namespace handwheel {

// Flips an edge: replaces it by the other diagonal of its two faces. Returns false, without a change, if there is no
// second face, a new face would have no area, or the diagonal exists already.
bool flipEdge(HalfEdgeMesh& mesh, HalfEdge h);

// Splits an edge with two faces by a new vertex; each face becomes two. The second halves become the last two faces;
// the half of the face of h comes first. Returns a half-edge that starts at the new vertex.
HalfEdge splitEdge(HalfEdgeMesh& mesh, HalfEdge h, const Vec3& p);

}  // namespace handwheel
