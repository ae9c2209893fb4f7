// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/search/FaceHierarchy.h"

#include <span>

namespace handwheel {

// The pick radius of a hole's loop in logical pixels. A loop nearer to the pick ray is preferred to the face below it.
inline constexpr double kHolePickRadius = 8.0;

// Picks the boundary loop at the pointer and returns its index, or nothing if there is none. The result is the nearest
// loop within kHolePickRadius that the surface does not hide. If there is no such loop, it is the loop with the
// smallest projected area through which the pick ray passes, provided that the ray meets the surface farther from the
// viewer. Sheet boundaries are excluded from the second test, since they surround the whole sheet. The loops must
// belong to the mesh; the hierarchy may belong to an older version of the mesh. O(all loops) plus O(log n) for each
// nearby loop.
std::optional<std::size_t> pickHole(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops,
                                    const FaceHierarchy& faces, const PickRay& pickRay);

}  // namespace handwheel
