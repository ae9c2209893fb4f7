// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/EdgeTable.h"

#include <optional>
#include <utility>
#include <vector>

namespace handwheel {

// Inconsistent orientations: neighbouring triangles that traverse their common edge in the same direction. Of edges of
// two triangles.
struct OrientationFaults {
  std::vector<std::uint32_t> trianglesToReverse;  // as the function of this name
  // Edges of a non-orientable surface at which they disagree after that, as pairs of points.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> nonOrientableEdges;
};
// O(n).
OrientationFaults findOrientationFaults(const EdgeTable& edges, std::span<const Triangle> triangles,
                                        Progress progress = {});

// The edges at which a non-orientable surface cannot be oriented consistently, as findOrientationFaults(); empty where
// every part can be oriented. O(n).
std::vector<std::pair<std::uint32_t, std::uint32_t>> nonOrientableEdges(const EdgeTable& edges,
                                                                        std::span<const Triangle> triangles,
                                                                        Progress progress = {});

// An orientation-reversing cycle: a closed path of edges along which left becomes right. Who follows it comes back
// mirrored. Where it follows the border it has no length, as nothing is to be cut there.
struct OrientationReversingCycle {
  double length = 0.0;                   // mm, inside the surface
  std::vector<std::uint32_t> halfEdges;  // 3 · triangle + corner: one along each edge inside, in order
  bool isOnBorder = false;               // part of it follows the border
};

// Finds the shortest orientation-reversing cycle that is not longer than a limit. None where there is none. Each begins
// at an edge where the triangles disagree, so the search starts from there only, among the vertices and their mirror
// images (Dijkstra, "A note on two problems in connexion with graphs", 1959). O(s r log r) for s such edges and r
// vertices within half the length.
std::optional<OrientationReversingCycle> shortestOrientationReversingCycle(const EdgeTable& edges,
                                                                           std::span<const Triangle> triangles,
                                                                           std::span<const Vec3> points, double longest,
                                                                           Progress progress = {});

}  // namespace handwheel
