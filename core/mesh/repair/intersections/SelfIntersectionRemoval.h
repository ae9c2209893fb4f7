// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <utility>
#include <vector>

namespace handwheel {

// Finds the pairs of intersecting faces. The mesh is treated as a file of this number type stores it. Returns an empty
// list if cancelled.
std::vector<std::pair<Face, Face>> selfIntersectingPairs(const HalfEdgeMesh& mesh, NumberType numbers,
                                                         Progress progress = {});
// Counts the pairs that selfIntersectingPairs() finds. Returns 0 if cancelled.
std::size_t countSelfIntersections(const HalfEdgeMesh& mesh, NumberType numbers, Progress progress = {});

// Finds all faces connected to the given ones through self-intersections. The result contains the faces that intersect
// the given ones, the faces that intersect those, and so on. The mesh is treated as a file of this number type stores
// it. Returns an empty list if cancelled.
std::vector<Face> intersectionCluster(const HalfEdgeMesh& mesh, const std::vector<Face>& faces, NumberType numbers,
                                      Progress progress = {});

// The result of removeSelfIntersections().
struct IntersectionRemoval {
  bool changed = false;                 // false: the mesh is unchanged
  std::size_t cutFaces = 0;             // number of cut faces of the original mesh; cut only in a trial if not changed
  std::size_t intersectionsBefore = 0;  // intersecting pairs of faces in the whole mesh, rounded to the number type
  std::size_t intersectionsAfter = 0;
  std::size_t innerFaces = 0;   // removed pieces of walls inside united solids
  std::size_t joinedFaces = 0;  // removed pieces of surfaces that coincide (joinCoincidentPieces())
};

// Removes self-intersections by cutting the faces and reconnecting the pieces. Faces are cut along their intersections
// (autorefine()), and the pieces are paired differently: two sheets that crossed now touch along the cut, each on its
// side, and are separated in the last digits (separateCoincidentVertices()), so that every piece of the surface keeps
// its position and nothing intersects. Of surfaces that coincide in a plane, pieces that bound nothing are removed
// (joinCoincidentPieces()), and solids with a common wall are united (uniteAtWalls()). The removal starts with the
// given faces and includes all faces that intersect the cut ones. It is abandoned, and the mesh is unchanged, if there
// are too many pairs (tolerance::kMaxSelfIntersectionPairs), if the result would have more self-intersections than
// allowed, or if cancelled. O(n) for the mesh and O(m log m) for m intersections.
IntersectionRemoval removeSelfIntersections(HalfEdgeMesh& mesh, const std::vector<Face>& faces, NumberType numbers,
                                            std::size_t allowed, Progress progress = {});
// Removes all self-intersections connected with these faces, as removeSelfIntersections() does. Only self-intersections
// that are unrelated to these faces may remain.
IntersectionRemoval removeAllSelfIntersections(HalfEdgeMesh& mesh, const std::vector<Face>& faces, NumberType numbers,
                                               Progress progress = {});
// Cuts all faces that intersect, and all walls that touch (findTouchingWalls()), and removes what is inside of the
// union. Otherwise like removeAllSelfIntersections().
IntersectionRemoval uniteIntersecting(HalfEdgeMesh& mesh, NumberType numbers, Progress progress = {});

}  // namespace handwheel
