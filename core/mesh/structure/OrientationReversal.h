// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/EdgeTable.h"

#include <optional>
#include <utility>
#include <vector>

namespace handwheel {

// Inconsistent orientations: neighbouring triangles that traverse their common edge in the same direction. Only edges
// of two triangles are considered.
struct OrientationFaults {
  std::vector<std::uint32_t> trianglesToReverse;  // result of the function trianglesToReverse()
  // Edges of a non-orientable surface at which triangles still disagree after the reversal, as pairs of points.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> nonOrientableEdges;
};
// Finds the inconsistent orientations of neighbouring triangles. O(n).
OrientationFaults findOrientationFaults(const EdgeTable& edges, std::span<const Triangle> triangles,
                                        Progress progress = {});

// Finds the edges at which a non-orientable surface cannot be oriented consistently, as findOrientationFaults() does.
// The result is empty if every part can be oriented. O(n).
std::vector<std::pair<std::uint32_t, std::uint32_t>> nonOrientableEdges(const EdgeTable& edges,
                                                                        std::span<const Triangle> triangles,
                                                                        Progress progress = {});

// An orientation-reversing cycle: a closed path of edges along which left becomes right. Parts along the border have no
// length, because no cut is needed there.
struct OrientationReversingCycle {
  double length = 0.0;                   // length of the part inside the surface, mm
  std::vector<std::uint32_t> halfEdges;  // half-edges (3 · triangle + corner), one for each inner edge, in order
  bool isOnBorder = false;               // true if a part of the cycle follows the border
};

// Finds the shortest orientation-reversing cycle that is not longer than a limit, if there is one. Each cycle contains
// an edge where the triangles disagree, so the search starts only there. It finds paths from a vertex to the same
// vertex with reversed orientation (Dijkstra, "A note on two problems in connexion with graphs", 1959). O(s r log r)
// for s such edges and r vertices within half of the longest length.
std::optional<OrientationReversingCycle> shortestOrientationReversingCycle(const EdgeTable& edges,
                                                                           std::span<const Triangle> triangles,
                                                                           std::span<const Vec3> points, double longest,
                                                                           Progress progress = {});

}  // namespace handwheel
