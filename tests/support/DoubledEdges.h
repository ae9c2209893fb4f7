// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

namespace handwheel::test {

// A mesh with two pairs of doubled edges: a ring of two cells. Each cell is cut into two triangles: two edges run
// between the two inner vertices, 0 and 1, and two between the outer ones, 2 and 3. A valid half-edge mesh, though no
// simplicial complex.
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
