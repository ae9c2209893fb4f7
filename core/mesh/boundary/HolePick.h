// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/search/FaceHierarchy.h"

#include <span>

namespace handwheel {

// The pick radius of a hole's loop in logical pixels. A loop nearer to the pick ray is preferred to the face below it.
inline constexpr double kHolePickRadius = 8.0;

// Picks the boundary loop at the pointer. It is the nearest within kHolePickRadius that the surface does not hide; else
// the smallest, as it appears, that the pick ray passes through, if it is nearer to the viewer than the surface is
// there. Sheet boundaries are not picked in the second way, since they surround the whole sheet. The index in the list,
// or none. The loops are those of the mesh; the hierarchy may be of an older version of it. O(all loops), and O(log n)
// for each that is near.
std::optional<std::size_t> pickHole(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops,
                                    const FaceHierarchy& faces, const PickRay& pickRay);

}  // namespace handwheel
