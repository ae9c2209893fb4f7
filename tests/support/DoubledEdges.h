// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

namespace handwheel::test {

// Returns a mesh with two pairs of doubled edges. It is a ring of two cells, each cut into two triangles. Two edges
// connect the inner vertices 0 and 1, and two edges connect the outer vertices 2 and 3. The mesh is a valid half-edge
// mesh, but not a simplicial complex.
inline HalfEdgeMesh doubledEdges() {
  HalfEdgeMesh mesh;
  for (const Vec3& p : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(2, 0, 0), Vec3(-2, 0, 0)}) mesh.addVertex(p);
  mesh.addSlot({0, 2, 3}, {10, kNone, 3});
  mesh.addSlot({0, 3, 1}, {2, 6, kNone});
  mesh.addSlot({1, 3, 2}, {4, kNone, 9});
  mesh.addSlot({1, 2, 0}, {8, 0, kNone});
  return mesh;
}

}  // namespace handwheel::test
