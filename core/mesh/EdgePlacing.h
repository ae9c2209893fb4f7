// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/VertexHolds.h"

#include <optional>

namespace handwheel {

// Where the vertex goes that an edge shrinks to, and what that costs.
struct Placing {
  Vec3 place = Vec3::Zero();
  double cost = 0.0;  // mm⁴: area times squared distance
};

// The place with the least sum of squared distances from the planes of the faces around the edge's ends, weighted by
// their areas, and from planes through open and sharp edges there, upright on their faces. What must stay stays. None
// where the edge cannot shrink for that, or the cost is not finite. O(k) for k faces around the ends.
std::optional<Placing> placingOf(const HalfEdgeMesh& mesh, const VertexHolds& holds, HalfEdge h);

}  // namespace handwheel
