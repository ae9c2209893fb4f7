// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/FaceLocator.h"

#include <functional>
#include <vector>

namespace handwheel {

// Faces of a mesh with the shapes that a move would give them.
struct MovedFaces {
  std::vector<Face> faces;             // face numbers in ascending order
  std::vector<TrianglePoints> shapes;  // new shapes, one per face
};

// Returns the slimness of a triangle: twice its area over its longest side squared. It is 0 for a triangle without area
// and 0.87 for an equilateral triangle.
double slimness(const TrianglePoints& t);

// Returns true if a face may change to a new shape. It may neither turn by 90° or more, nor lose its area, nor become
// much slimmer unless it stays well shaped. A face that had no area may take any shape.
bool mayBecome(const TrianglePoints& before, const TrianglePoints& after);

// Visits each moved face that would newly intersect another one, moved or not. Shared edges and vertices, and pairs
// that already intersect, do not count. Calls visit(index) until it returns false; returns false if a visit returned
// false. An index may occur more than once. Faces without area are ignored. near must be built from the mesh before the
// move.
bool forEachNewCrossing(const FaceLocator& near, const MovedFaces& moved,
                        const std::function<bool(std::size_t)>& visit);

// Converts triangles to a soup in which each has points of its own.
TriangleSoup soupOf(const std::vector<TrianglePoints>& triangles);

}  // namespace handwheel
