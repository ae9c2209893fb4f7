// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/EdgeTable.h"

#include <vector>

namespace handwheel {

// Finds the triangles to reverse so that neighbours have consistent orientation. Neighbours share an edge with no third
// triangle. In each part, the fewest possible triangles are reversed. On non-orientable surfaces some edges stay
// inconsistent. O(n). The result is invalid if cancelled.
std::vector<bool> trianglesToReverse(const EdgeTable& edges, std::span<const Triangle> triangles,
                                     Progress progress = {});

// Returns the half-edge along the same edge after its triangle is reversed. The triangle (a, b, c) becomes (a, c, b),
// the result of reversed().
inline std::uint32_t reversedHalfEdge(std::uint32_t h) {
  return h - h % 3 + (2 - h % 3);
}
inline Triangle reversed(const Triangle& t) {
  return {t[0], t[2], t[1]};
}

}  // namespace handwheel
