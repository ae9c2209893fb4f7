// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/search/FaceHierarchy.h"

#include <span>

namespace handwheel {

// The pick radius of a boundary loop in logical pixels (He 2008, section 3.1.1). A point of a loop within it attracts
// the pointer.
inline constexpr double kBoundaryPickRadius = 12.0;

// A point of a boundary loop.
struct BoundaryPoint {
  std::size_t loop = 0;  // index in the list
  HalfEdge at = kNone;   // the open half-edge that starts at the point
};

// Picks the boundary point that is nearest to the pick ray. It must be within the radius, and the surface must not hide
// it. Points at the position "without" are ignored. The loops must belong to the mesh; the hierarchy may belong to an
// older version. O(points of the nearby loops).
std::optional<BoundaryPoint> pickBoundaryPoint(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops,
                                               const FaceHierarchy& faces, const PickRay& pickRay,
                                               const std::optional<Vec3>& without = {});

}  // namespace handwheel
