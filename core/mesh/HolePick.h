// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/BoundaryLoops.h"
#include "mesh/FaceHierarchy.h"

#include <span>

namespace handwheel {

// A loop nearer to the line of sight than this wins over the face below it; logical pixels.
inline constexpr double kLoopPickRadius = 8.0;

// The loop that one points at: the nearest within kLoopPickRadius that the surface does not hide; else the smallest, as
// it appears, that one looks through, if it is nearer to the viewer than the surface is there. Rims are not looked
// through, since they surround the whole sheet. The index in the list, or none. The loops are those of the mesh; the
// hierarchy may be of an older version of it. O(all loops), and O(log n) for each that is near.
std::optional<std::size_t> pickHole(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops,
                                    const FaceHierarchy& faces, const Sight& sight);

}  // namespace handwheel
