// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/EdgeTable.h"

#include <vector>

namespace handwheel {

// Which half-edges pairEdges() has joined.
struct PairedEdges {
  std::vector<std::uint32_t> opposite;  // per half-edge: the paired one, or a value of Open
  std::size_t nonManifoldEdges = 0;
  std::size_t seams = 0;  // half-edges on edges of two or more that found no partner
};

// Pairs the half-edges of every edge. Where more than two triangles meet, those that bound the same solid wedge become
// neighbours, so that solids that touch along an edge are separated there. Triangles must be oriented already. The
// result is invalid if cancelled.
PairedEdges pairEdges(const EdgeTable& edges, std::span<const Triangle> triangles, std::span<const Vec3> points,
                      Progress progress = {});

}  // namespace handwheel
