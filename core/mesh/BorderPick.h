// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/BoundaryLoops.h"
#include "mesh/FaceHierarchy.h"

#include <span>

namespace handwheel {

// A point of a boundary loop attracts a pointer that is as near (He 2008, section 4.2); logical pixels.
inline constexpr double kBorderPickRadius = 12.0;

struct BorderPoint {
  std::size_t loop = 0;  // in the list
  HalfEdge at = kNone;   // the open half-edge that leaves it
};

// The point of a loop that the line of sight passes nearest, within the radius, if the surface does not hide it. Points
// at the position "without" do not count. The loops are those of the mesh; the hierarchy may be of an older version.
// O(points of the loops near by).
std::optional<BorderPoint> pickBorderPoint(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops,
                                           const FaceHierarchy& faces, const Sight& sight,
                                           const std::optional<Vec3>& without = {});

}  // namespace handwheel
