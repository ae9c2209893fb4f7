// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/simplify/VertexConstraints.h"

#include <optional>

namespace handwheel {

// The position of the vertex to which an edge collapses, and its cost.
struct CollapsePlacement {
  Vec3 position = Vec3::Zero();
  double cost = 0.0;  // area times squared distance, mm⁴
};

// Computes the position with the least quadric error for an edge collapse. The error is the sum of squared distances
// from the planes of the faces around the edge's ends, weighted by their areas, and from planes through open and sharp
// edges there, perpendicular to their faces. Constrained vertices stay. Returns nothing if the constraints forbid the
// collapse, or the cost is not finite. O(k) for k faces around the ends.
std::optional<CollapsePlacement> collapsePlacement(const HalfEdgeMesh& mesh, const VertexConstraints& holds,
                                                   HalfEdge h);

}  // namespace handwheel
