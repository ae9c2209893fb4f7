// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/selection/FaceSelection.h"
#include "mesh/structure/EdgeTable.h"

namespace handwheel {

// Returns true if the corners of a triangle are an even permutation of ascending ones. Triangles over the same three
// positions with the same result have the same orientation.
inline bool looksUp(const Triangle& t) {
  return (t[0] < t[1]) + (t[1] < t[2]) + (t[2] < t[0]) == 2;
}

// A group of faces with the same three positions.
struct FaceGroup {
  Triangle positions;       // ascending
  std::vector<Face> faces;  // ascending
};

// Finds groups of faces with the same three positions, in order of the positions. edges must be built from these
// triangles. O(n). The result is invalid if cancelled.
std::vector<FaceGroup> equalFaces(std::span<const Triangle> triangles, const EdgeTable& edges, Progress progress = {});

// Removes faces that have the same three positions as another face. Connected duplicates are treated alike: one of each
// stays, or none if the surface is closed without them (a wall inside a solid, a flap), or both if they are the two
// sides of a plate, which is already closed. only restricts the removal to groups that contain one of these faces;
// null: all groups. Returns the number of removed faces. Relinks the mesh if any was removed. The mesh is invalid if
// cancelled.
std::size_t removeDuplicateFaces(HalfEdgeMesh& mesh, Progress progress = {}, const FaceSelection* only = nullptr);

}  // namespace handwheel
