// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/selection/FaceSelection.h"
#include "mesh/structure/EdgeTable.h"

namespace handwheel {

// Returns true if a triangle's corners are an even permutation of their ascending order. Triangles over the same three
// positions with the same result have the same orientation.
inline bool looksUp(const Triangle& t) {
  return (t[0] < t[1]) + (t[1] < t[2]) + (t[2] < t[0]) == 2;
}

// A group of faces with the same three positions.
struct FaceGroup {
  Triangle positions;       // the three positions in ascending order
  std::vector<Face> faces;  // face numbers in ascending order
};

// Finds groups of faces with the same three positions, in order of the positions. edges must be built from these
// triangles. O(n). The result is invalid if cancelled.
std::vector<FaceGroup> equalFaces(std::span<const Triangle> triangles, const EdgeTable& edges, Progress progress = {});

// Removes faces that have the same three positions as another face. Connected duplicates are treated alike: one face of
// each group stays, or no face if the surface is closed without them (a wall inside a solid, a flap), or both faces if
// they are the two sides of a plate, which is already closed. If "only" is not null, the removal is restricted to
// groups that contain one of its faces. Returns the number of removed faces. Relinks the mesh if a face was removed.
// The mesh is invalid if cancelled.
std::size_t removeDuplicateFaces(HalfEdgeMesh& mesh, Progress progress = {}, const FaceSelection* only = nullptr);

}  // namespace handwheel
