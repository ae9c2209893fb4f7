// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/selection/FaceSelection.h"
#include "mesh/structure/EdgeTable.h"

namespace handwheel {

// The orientation of a triangle: whether its corners are an even permutation of ascending ones. Of triangles over the
// same three positions, those with the same answer look the same way.
inline bool looksUp(const Triangle& t) {
  return (t[0] < t[1]) + (t[1] < t[2]) + (t[2] < t[0]) == 2;
}

// A group of faces with the same three positions.
struct FaceGroup {
  Triangle positions;       // ascending
  std::vector<Face> faces;  // ascending
};

// Finds groups of faces with the same three positions, in order of the positions. edges: of these triangles. O(n). The
// result is invalid if cancelled.
std::vector<FaceGroup> equalFaces(std::span<const Triangle> triangles, const EdgeTable& edges, Progress progress = {});

// Removes faces that have the same three positions as another face. Connected duplicates are treated alike: one of each
// stays, or none where the surface is closed without them (a wall inside a solid, a flap), or both where they are the
// two sides of a plate, which is closed as it is. only: of groups with one of these faces; what stays of them is as
// with all (null). Returns the number removed. Relinks when any was. The mesh is invalid if cancelled.
std::size_t removeDuplicateFaces(HalfEdgeMesh& mesh, Progress progress = {}, const FaceSelection* only = nullptr);

}  // namespace handwheel
