// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

namespace handwheel {

// Visits the half-edges that leave a vertex within one fan. Calls visit(g) for those in the fan of h, h first, until it
// returns false. Returns false when a visit did. Allocates nothing, and takes no longer than the visits; a visit may
// change corners, but no opposites.
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

// Beyond so many faces around one of its ends an edge is not collapsed: each test walks around both, and a vertex with
// thousands of faces would make that quadratic.
inline constexpr std::size_t kLargestFan = 256;

// Whether collapsing an edge keeps the topology of the surface. It is the link condition (Dey, Edelsbrunner, Guha,
// Nekhayev, "Topology preserving edge contraction", 1999). A border is joined to one more vertex; Open::Seam counts as
// border. The half-edge must be proper. O(k log k) for k faces around its ends; false where there are too many.
bool canCollapse(const HalfEdgeMesh& mesh, HalfEdge h);

// Collapses an edge to a vertex at p. The vertex is from(h), while to(h) is left without faces and one or two faces are
// removed. canCollapse() must hold. Returns a half-edge that leaves the vertex.
HalfEdge collapseEdge(HalfEdgeMesh& mesh, HalfEdge h, const Vec3& p);

}  // namespace handwheel
