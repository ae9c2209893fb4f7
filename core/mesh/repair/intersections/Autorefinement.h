// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Tolerance.h"
#include "mesh/repair/intersections/SharedPlanes.h"
#include "mesh/structure/TriangleSoup.h"
#include "proximity/SelfIntersection.h"

#include <map>
#include <span>
#include <vector>

namespace handwheel {

// The result of autorefine(): triangles cut along their intersections.
struct Autorefinement {
  std::vector<Vec3> points;                                 // points of the soup, then added ones
  std::map<std::uint32_t, std::vector<Triangle>> piecesOf;  // pieces of each cut triangle; empty if no piece has area
};

// Cuts pairs of intersecting triangles along their common points, segments and areas. Other triangles are cut at edges
// that get a point, so that pieces meet in common corners and edges only: the pieces are the faces of the exact
// arrangement, triangulated by a constrained Delaunay triangulation of each triangle's plane. Points are rounded to the
// number type only at the end: pieces that lose a corner are left out, so a closed surface stays closed, and a piece
// may cross another in the last digit. Indices of points of the soup that share a position must be equal; triangles
// must have area. O(m log m) for m intersections plus one pass over the soup. Nothing is cut if a triangle would be cut
// more than mostCuts times (folded regions, which would take minutes, exceed the default), if coordinates range over
// more than tolerance::kCutBits bits, or if CGAL fails. The result is invalid if cancelled. Corners in shared planes
// are treated as lying in them exactly, so that surfaces that coincide except for rounding have equal pieces; the
// corners themselves do not move.
Autorefinement autorefine(const TriangleSoup& soup, std::span<const TrianglePair> pairs, NumberType numbers,
                          Progress progress = {}, const SharedPlanes& planes = {},
                          std::size_t mostCuts = tolerance::kCutsPerFace);

}  // namespace handwheel
