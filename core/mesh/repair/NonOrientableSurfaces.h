// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"
#include "mesh/selection/FaceSelection.h"

namespace handwheel {

// The result of cutting non-orientable parts.
struct NonOrientableCut {
  std::size_t loops = 0;         // number of cut loops
  std::size_t opened = 0;        // number of edges of cuts that start and end at a border or another cut
  std::vector<Vertex> vertices;  // vertices along the cuts, ascending
  bool isTwoSided = false;       // true if no non-orientable part is left
};

// Cuts non-orientable parts of the surface along shortest orientation-reversing cycles. The surface is treated as a
// file stores it; see shortestOrientationReversingCycle() for the cycles. Each part is cut until it is orientable, at
// most 2 minus its Euler characteristic times. The cut is opened to a slit: the vertices on its smaller side move into
// the faces on that side by a tenth of the size of these faces. Cycles longer than "longest" (mm) are not cut. The
// number of faces and the Euler characteristic do not change, except that a cut from border to border adds 1 to the
// characteristic. If "only" is not null, the cuts are restricted to its faces, which must form whole components. The
// result is invalid if cancelled. O(n) for each cycle and the search for it.
NonOrientableCut cutNonOrientable(HalfEdgeMesh& mesh, double longest, NumberType numbers, Progress progress = {},
                                  const FaceSelection* only = nullptr);

// The permission for cuts from border to border. Such a cut widens an opening and leaves it open.
enum class BoundaryCuts { No, Yes };

// Makes a surface orientable by cutNonOrientable(), and closes the slits. The slits are closed by fillHoles() or, if
// that fails, by closeObstructedHoles(). Returns the number of cuts. Returns 0 and leaves the mesh unchanged if a slit
// stays open, if more faces would intersect than before, or if cancelled. Intersecting faces may be cut; no other face
// is removed. The parameter "only" has the same meaning as in cutNonOrientable().
std::size_t closeNonOrientable(HalfEdgeMesh& mesh, const FillOptions& options, double longest,
                               BoundaryCuts boundaryCuts, Progress progress = {}, const FaceSelection* only = nullptr);

}  // namespace handwheel
