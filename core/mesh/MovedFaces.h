// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/NearFaces.h"

#include <functional>
#include <vector>

namespace handwheel {

// Faces of a mesh as a move would leave them.
struct MovedFaces {
  std::vector<Face> faces;             // rising
  std::vector<TrianglePoints> shapes;  // of each
};

// Twice the area over the square of the longest side: 0 without area, 0.87 equilateral.
double slimness(const TrianglePoints& t);

// Whether a face may take this shape: neither turned by 90° or more, nor without area, nor much slimmer than it was
// unless it stays well shaped. A face that had no area may take any.
bool mayBecome(const TrianglePoints& before, const TrianglePoints& after);

// Calls visit(index) for each moved face that would meet another one, moved or not, in more than what they share and
// does not do so now, until it returns false. False when a visit did. An index may come more than once. Faces without
// area are not judged. near: of the mesh before the move.
bool forEachNewCrossing(const NearFaces& near, const MovedFaces& moved, const std::function<bool(std::size_t)>& visit);

// Each triangle with points of its own.
TriangleSoup soupOf(const std::vector<TrianglePoints>& triangles);

}  // namespace handwheel
