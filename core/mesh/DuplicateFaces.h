// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/EdgeTable.h"
#include "mesh/HalfEdgeMesh.h"

namespace handwheel {

struct FaceGroup {
  Triangle positions;       // ascending
  std::vector<Face> faces;  // ascending
};

// The faces that share their three positions with another one, in order of the positions. edges: of these triangles.
// O(n). Of no use once cancelled.
std::vector<FaceGroup> equalFaces(std::span<const Triangle> triangles, const EdgeTable& edges, Progress progress = {});

// Removes faces that have the same three positions as another face. Duplicates that hang together are judged together:
// one of each stays, or none where the surface is closed without them (a wall inside a solid, a flap), or both where
// they are the two sides of a plate, which is closed as it is. Returns how many went. Relinks when any did.
// Once cancelled, the mesh is of no use.
std::size_t removeDuplicateFaces(HalfEdgeMesh& mesh, Progress progress = {});

}  // namespace handwheel
