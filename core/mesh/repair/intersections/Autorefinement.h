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
  std::vector<Vec3> points;                                 // the soup's, then new ones
  std::map<std::uint32_t, std::vector<Triangle>> piecesOf;  // per triangle that is cut; none where nothing has area
};

// Cuts pairs of intersecting triangles along their common points, segments and areas. Every other triangle is cut at an
// edge that gets a point by this, so that pieces meet in common corners and edges only: the pieces are the faces of the
// exact arrangement, triangulated by a constrained Delaunay triangulation of each triangle's plane. Only at the end are
// points rounded to numbers: pieces that lose a corner by it are left out, so what was closed stays closed, and a piece
// may come to lie across another by the last digit. Indices of points of the soup that share a position must be equal;
// triangles must have area. O(m log m) for m intersections beside one pass over the soup. Nothing is cut when a
// triangle would be cut more than mostCuts times (by default, that is a folded region, and would take minutes),
// where coordinates range over more than tolerance::kCutBits, or where the library gives up. The result is invalid if
// cancelled. Triangles with corners in shared planes are cut as if these lay in them exactly, so that surfaces that lie
// on each other but for rounding have equal pieces; the corners themselves stay where they are.
Autorefinement autorefine(const TriangleSoup& soup, std::span<const TrianglePair> pairs, NumberType numbers,
                          Progress progress = {}, const SharedPlanes& planes = {},
                          std::size_t mostCuts = tolerance::kCutsPerFace);

}  // namespace handwheel
