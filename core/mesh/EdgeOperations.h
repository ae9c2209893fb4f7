// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HalfEdgeMesh.h"

namespace handwheel {

// Replaces edge h and its two faces by the other diagonal. False, and nothing changed, when there is no second face, a
// new face would have no area, or the diagonal exists already.
bool flipEdge(HalfEdgeMesh& mesh, HalfEdge h);

// Puts a vertex into an edge with two faces; each becomes two. The second halves are the two last faces, that of h
// first. Returns a half-edge that leaves the new vertex.
HalfEdge splitEdge(HalfEdgeMesh& mesh, HalfEdge h, const Vec3& p);

}  // namespace handwheel
