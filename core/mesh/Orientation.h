// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/EdgeTable.h"

#include <vector>

namespace handwheel {

// Per triangle, whether it must be turned over so that triangles that share an edge of two agree; the fewest in each
// part are turned. On one-sided surfaces some edges stay in disagreement. O(n).
// Of no use once cancelled.
std::vector<bool> trianglesToTurn(const EdgeTable& edges, std::span<const Triangle> triangles, Progress progress = {});

// The half-edge that runs along the same edge after its triangle (a, b, c) became (a, c, b), and that turned triangle.
inline std::uint32_t turnedHalfEdge(std::uint32_t h) {
  return h - h % 3 + (2 - h % 3);
}
inline Triangle turned(const Triangle& t) {
  return {t[0], t[2], t[1]};
}

}  // namespace handwheel
