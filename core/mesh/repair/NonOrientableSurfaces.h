// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"
#include "mesh/selection/FaceSelection.h"

namespace handwheel {

// The result of cutting non-orientable parts.
struct NonOrientableCut {
  std::size_t loops = 0;         // cut along
  std::size_t opened = 0;        // edges of cuts that begin and end at a border, or at a cut
  std::vector<Vertex> vertices;  // along the cuts, rising
  bool isTwoSided = false;       // no non-orientable part is left
};

// Cuts non-orientable parts of the surface along shortest orientation-reversing cycles. The surface is taken as a file
// stores it; for the cycles see shortestOrientationReversingCycle(). Parts are cut until they are orientable: at most
// as often as a part's Euler characteristic is below 2. The cut is opened to a slit: what is on its smaller side moves
// into its own faces by a tenth of them. Cycles longer than this (mm) are not cut. The number of faces stays, and so
// does the characteristic, but for 1 more with a cut from border to border. only: whole components, null for all. The
// result is invalid if cancelled. O(n) for each cycle and the search for it.
NonOrientableCut cutNonOrientable(HalfEdgeMesh& mesh, double longest, NumberType numbers, Progress progress = {},
                                  const FaceSelection* only = nullptr);

// Whether cuts from border to border are allowed. Such a cut makes an opening wider and leaves it open.
enum class BoundaryCuts { No, Yes };

// Makes a surface orientable by cutNonOrientable(), and closes the slits. They are closed by fillHoles(), else by
// closeObstructedHoles(). Returns the number of cuts: 0, and the mesh is as it was, where a slit stays open, where more
// faces would intersect than before, or if cancelled. Intersecting faces may be cut; no other face is removed. only: as
// above.
std::size_t closeNonOrientable(HalfEdgeMesh& mesh, const FillOptions& options, double longest,
                               BoundaryCuts boundaryCuts, Progress progress = {}, const FaceSelection* only = nullptr);

}  // namespace handwheel
