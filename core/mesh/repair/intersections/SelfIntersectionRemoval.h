// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/repair/intersections/OverlapUnion.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <utility>
#include <vector>

namespace handwheel {

// Finds the pairs of intersecting faces, as a file of these numbers stores the mesh. Empty if cancelled.
std::vector<std::pair<Face, Face>> selfIntersectingPairs(const HalfEdgeMesh& mesh, NumberType numbers,
                                                         Progress progress = {});
// Counts them. 0 if cancelled.
std::size_t countSelfIntersections(const HalfEdgeMesh& mesh, NumberType numbers, Progress progress = {});

// Finds all faces connected to the given ones through self-intersections. These are the faces that intersect them, as
// such a file stores the mesh, those that intersect these, and so on. Empty if cancelled.
std::vector<Face> intersectionCluster(const HalfEdgeMesh& mesh, const std::vector<Face>& faces, NumberType numbers,
                                      Progress progress = {});

// The result of removeSelfIntersections().
struct IntersectionRemoval {
  bool changed = false;                 // else the mesh is as it was
  std::size_t cutFaces = 0;             // of the mesh before; tried, when not changed
  std::size_t intersectionsBefore = 0;  // intersecting pairs of faces, in the whole mesh, rounded to numbers
  std::size_t intersectionsAfter = 0;
  std::size_t innerFaces = 0;  // pieces that were removed with walls of united solids
};

// Removes self-intersections by cutting the faces and reconnecting the pieces. Faces are cut along their intersections
// (autorefine()), and the pieces are joined the other way: where two sheets crossed, two now touch along the cut, each
// on its side, and are separated by the last digits (separateCoincidentVertices()), so that every piece of the surface
// stays where it was and nothing intersects. Where surfaces lie on each other in one plane, pieces that bound nothing
// are removed (joinCoincidentPieces()), and solids with a wall in common are united (uniteAtWalls()). Begins with
// these faces and includes whatever intersects what it has to cut. Abandoned, with the mesh unchanged, when that is too
// much (tolerance::kMaxSelfIntersectionPairs), when the result would have more self-intersections than allowed, or if
// cancelled. Needs O(n) for the mesh beside O(m log m) for m intersections.
IntersectionRemoval removeSelfIntersections(HalfEdgeMesh& mesh, const std::vector<Face>& faces, NumberType numbers,
                                            std::size_t allowed, Progress progress = {});
// Removes all self-intersections connected with these faces, as removeSelfIntersections() does. Allowed are those that
// have nothing to do with these faces.
IntersectionRemoval removeAllSelfIntersections(HalfEdgeMesh& mesh, const std::vector<Face>& faces, NumberType numbers,
                                               Progress progress = {}, Uniting which = Uniting::SharedWalls);

}  // namespace handwheel
