// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/EdgeTable.h"

#include <optional>
#include <utility>
#include <vector>

namespace handwheel {

// Edges with two triangles of a surface with one side only, at which they disagree however each is turned: the fewest
// turned triangles that trianglesToTurn() finds leave these. As pairs of points; empty where every part can be
// oriented. O(n).
std::vector<std::pair<std::uint32_t, std::uint32_t>> oneSidedEdges(const EdgeTable& edges,
                                                                   std::span<const Triangle> triangles,
                                                                   Progress progress = {});

// A closed way along edges of a surface on which left becomes right: whoever goes along it comes back mirrored. Where
// it follows the border it counts for nothing, as nothing is to be cut there.
struct ReversingLoop {
  double length = 0.0;                   // mm, inside the surface
  std::vector<std::uint32_t> halfEdges;  // 3 · triangle + corner: one along each edge inside, in order
  bool isOnBorder = false;               // part of it follows the border
};

// The shortest such way that is not longer than this; none where there is none. Each begins at an
// edge where the triangles disagree, so it is looked for from there only, among the vertices and their mirror images
// (Dijkstra, "A note on two problems in connexion with graphs", 1959). O(s r log r) for s such edges and r vertices
// within half the length.
std::optional<ReversingLoop> shortestReversingLoop(const EdgeTable& edges, std::span<const Triangle> triangles,
                                                   std::span<const Vec3> points, double longest,
                                                   Progress progress = {});

}  // namespace handwheel
