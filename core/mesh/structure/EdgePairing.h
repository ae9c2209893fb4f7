// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/EdgeTable.h"

#include <vector>

namespace handwheel {

// The half-edges that pairEdges() joined.
struct PairedEdges {
  std::vector<std::uint32_t> opposite;  // paired half-edge of each half-edge, or a value of Open
  std::size_t nonManifoldEdges = 0;
  std::size_t seams = 0;  // number of unpaired half-edges on edges with two or more half-edges
};

// Pairs the half-edges of every edge. If more than two triangles meet, those that bound the same solid wedge become
// neighbours, so that solids that touch along an edge are separated at this edge. Triangles must already be oriented.
// The result is invalid if cancelled.
PairedEdges pairEdges(const EdgeTable& edges, std::span<const Triangle> triangles, std::span<const Vec3> points,
                      Progress progress = {});

}  // namespace handwheel
