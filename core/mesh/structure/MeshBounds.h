// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

namespace handwheel {

// Returns the bounding box of all live faces. O(n).
inline Box boundsOf(const HalfEdgeMesh& mesh) {
  Box box;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    for (const Vertex v : mesh.triangle(f)) box.extend(mesh.position(v));
  }
  return box;
}

// Returns the diagonal of the bounding box of all live faces, 0 for a mesh without faces.
inline double diagonalOf(const HalfEdgeMesh& mesh) {
  const Box box = boundsOf(mesh);
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

}  // namespace handwheel
