// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/holes/HoleContext.h"
#include "mesh/holes/Patch.h"

#include <optional>

namespace handwheel {

// Returns twice the vector area of the loop (Newell). Its direction is the normal of the loop's best plane, its length
// twice the area of the projection of the loop onto that plane.
Vec3 vectorAreaOf(const HoleContext& hole);

// Returns the extent of the loop along the normal of its best plane, mm.
double heightOf(const HoleContext& hole);

// Triangulates a hole in the least-squares plane of its loop by constrained Delaunay triangulation (CGAL). No vertices
// are added, so the patch is flat if the loop is, and otherwise leaves the plane only as far as the loop does. Returns
// nothing if the projection of the loop onto the plane crosses itself, or if cancelled. O(n log n).
std::optional<Patch> triangulateFlat(const HoleContext& hole, Progress progress = {});

}  // namespace handwheel
