// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/repair/OffsetDirection.h"

#include <vector>

namespace handwheel {

// One of the faces around a vertex, in counter-clockwise order. As seen from where the normals point to.
struct FanFace {
  FaceAtVertex face;
  Vec3 edge;  // from the vertex, of length 1: the face's, from which the next face lies on its other side
};

// The offsets of a vertex for the back of its fan, the faces around it.
struct VertexOffsets {
  // One for all faces, or two where no single one is behind all of them; none where two are not either.
  std::vector<Vec3> offsets;
  // Of two, the first is that of the faces with these numbers, end not included; the second that of all others.
  std::size_t begin = 0, end = 0;

  std::size_t offsetOf(std::size_t face) const { return offsets.size() == 2 && (face < begin || face >= end) ? 1 : 0; }
};

// Finds the offsets behind a fan. Where offsetBehind() has none for a closed fan, as where a sheet winds around a
// vertex, the fan is divided at two of its edges such that the direction of each part is behind its faces and behind
// the plane through both edges. Then the back is manifold, with a pair of triangles between its parts. O(n³) for such a
// fan, which is not divided if it has too many faces.
VertexOffsets vertexOffsets(const std::vector<FanFace>& fan, bool isClosed);

}  // namespace handwheel
