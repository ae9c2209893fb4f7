// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

namespace handwheel {

// Visits the half-edges that leave a vertex within one fan. Calls visit(g) for those in the fan of h, h first, until it
// returns false. Returns false if a visit did. Allocates no memory and takes time linear in the number of visits. A
// visit may change the corners of faces, but not the opposites of half-edges.
template <class Visit>
bool forEachInFan(const HalfEdgeMesh& mesh, HalfEdge h, Visit visit) {
  HalfEdge g = h;
  do {
    if (!visit(g)) return false;
    const HalfEdge back = HalfEdgeMesh::previous(g);
    g = mesh.hasOpposite(back) ? mesh.opposite(back) : kNone;
  } while (g != kNone && g != h);
  if (g == h) return true;
  for (g = h; mesh.hasOpposite(g);) {
    g = HalfEdgeMesh::next(mesh.opposite(g));
    if (!visit(g)) return false;
  }
  return true;
}

// The largest number of faces around an end of an edge that is collapsed. Each test walks around both ends, so without
// this limit the edges of a vertex with thousands of faces would take quadratic time.
inline constexpr std::size_t kLargestFan = 256;

// Returns true if collapsing an edge keeps the topology of the surface. It tests the link condition (Dey, Edelsbrunner,
// Guha, Nekhayev, "Topology preserving edge contraction", 1999). Borders are treated as joined to an additional vertex;
// Open::Seam counts as border. The half-edge must be proper. O(k log k) for k faces around its ends; returns false if
// there are too many.
bool canCollapse(const HalfEdgeMesh& mesh, HalfEdge h);

// Collapses an edge to a vertex at p. The vertex is from(h), while to(h) is left without faces and one or two faces are
// removed. canCollapse() must hold. Returns a half-edge that starts at the vertex.
HalfEdge collapseEdge(HalfEdgeMesh& mesh, HalfEdge h, const Vec3& p);

}  // namespace handwheel
