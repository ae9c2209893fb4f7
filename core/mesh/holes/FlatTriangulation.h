// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/holes/HoleContext.h"
#include "mesh/holes/Patch.h"

#include <optional>

namespace handwheel {

// Triangulates a hole in the least-squares plane of its loop by constrained Delaunay triangulation (CGAL). No new
// vertices, so that the patch is flat where the loop is, and elsewhere leans only as far as the loop leaves the plane.
// None where the loop crosses itself as seen along the normal of the plane, and when cancelled. O(n log n).
std::optional<Patch> triangulateFlat(const HoleContext& hole, Progress progress = {});

}  // namespace handwheel
