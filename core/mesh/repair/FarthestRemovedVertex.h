// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <optional>

namespace handwheel {

// The vertex of an earlier surface that is farthest outside a later one.
struct FarthestRemovedVertex {
  double distance = 0.0;  // distance to the later surface, mm
  Vec3 position = Vec3::Zero();
};

// Finds the vertex of "before", missing in "after", that is farthest outside the surface of "after". It shows what a
// change removed from the outside. Vertices inside, such as those of walls that a union removes, and debris of "before"
// do not count; the sign of SurfaceDistance decides between inside and outside. Returns nothing if the distance is at
// most tolerance::kRemovedPart times the diagonal of "before", if "after" has no surface, or if cancelled. O(n), or O(n
// log n) if a vertex and all of its surroundings are missing.
std::optional<FarthestRemovedVertex> farthestRemovedVertex(const HalfEdgeMesh& before, const HalfEdgeMesh& after,
                                                           Progress progress = {});

}  // namespace handwheel
