// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <optional>

namespace handwheel {

// The vertex of an earlier surface that is farthest outside a later one.
struct FarthestRemovedVertex {
  double distance = 0.0;  // mm, to the later surface
  Vec3 position = Vec3::Zero();
};

// Finds the vertex of "before", missing in "after", that is farthest outside the surface of "after". It shows what a
// change removed from the outside. Vertices inside, such as those of walls that a union removes, and debris of "before"
// do not count; the sign is that of SurfaceDistance. Returns nothing below tolerance::kRemovedPart, if "after" has no
// surface, or if cancelled. O(n), or O(n log n) if a vertex is missing with all its surroundings.
std::optional<FarthestRemovedVertex> farthestRemovedVertex(const HalfEdgeMesh& before, const HalfEdgeMesh& after,
                                                           Progress progress = {});

}  // namespace handwheel
