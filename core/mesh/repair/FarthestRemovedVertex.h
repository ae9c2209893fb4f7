// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <optional>

namespace handwheel {

// The vertex of an earlier surface that sticks out farthest from a later one.
struct FarthestRemovedVertex {
  double distance = 0.0;      // mm, from the later surface
  Vec3 place = Vec3::Zero();  // of the vertex
};

// What a change took away from the outside: of the vertices of "before" that "after" does not have, the one farthest
// outside of its surface. Vertices inside, as those of walls that a union removes, and debris of "before" do not count;
// the sign is that of SurfaceDistance. None below tolerance::kRemovedPart, where "after" has no surface, or if
// cancelled. O(n), and O(n log n) where a vertex is gone with all around it.
std::optional<FarthestRemovedVertex> farthestRemovedVertex(const HalfEdgeMesh& before, const HalfEdgeMesh& after,
                                                           Progress progress = {});

}  // namespace handwheel
