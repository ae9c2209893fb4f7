// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/repair/OffsetDirection.h"

#include <vector>

namespace handwheel {

// One of the faces around a vertex, in counter-clockwise order. The order is the one seen from the side to which the
// normals point.
struct FanFace {
  FaceAtVertex face;
  Vec3 edge;  // unit vector from the vertex along the edge before the face in this order
};

// The offsets of a vertex for the back of its fan, the faces around it.
struct VertexOffsets {
  // One offset for all faces, or two if no single offset is behind all faces. The list is empty if two do not suffice.
  std::vector<Vec3> offsets;
  // With two offsets, the first is for the faces begin…end - 1, the second for all others.
  std::size_t begin = 0, end = 0;

  std::size_t offsetOf(std::size_t face) const { return offsets.size() == 2 && (face < begin || face >= end) ? 1 : 0; }
};

// Finds the offsets behind a fan. If offsetBehind() has none for a closed fan, for example where a sheet winds around a
// vertex, the fan is divided at two of its edges such that the direction of each part is behind its faces and behind
// the plane through both edges. The back is then manifold, with a pair of triangles between its parts. O(n³) for such a
// fan, which is not divided if it has too many faces.
VertexOffsets vertexOffsets(const std::vector<FanFace>& fan, bool isClosed);

}  // namespace handwheel
