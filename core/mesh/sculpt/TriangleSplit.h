// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace handwheel {

// The triangles of a split triangle by point numbers. The corners are 0, 1, 2; the middle of the edge from corner k is
// 3 + k.
using TriangleSplit = std::vector<std::array<std::size_t, 3>>;

// Splits a triangle into one to four by the points on its edges. A split into three uses the shorter diagonal (He 2008,
// section 4.5); all parts have the orientation of the triangle. hasPoint states for each corner whether the edge that
// starts at it has a point. shorter(p, q, r, s) returns true if the diagonal p q is not longer than r s.
template <class Shorter>
TriangleSplit splitOf(const std::array<bool, 3>& hasPoint, Shorter shorter) {
  const auto count = std::count(hasPoint.begin(), hasPoint.end(), true);
  if (count == 3) return {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
  if (count == 0) return {{0, 1, 2}};
  std::size_t a = 0;  // start of the only edge with a point, or of the only edge without a point
  while (hasPoint[a] != (count == 1)) ++a;
  const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
  if (count == 1) return {{a, 3 + a, c}, {3 + a, b, c}};
  if (shorter(a, 3 + b, b, 3 + c)) return {{a, b, 3 + b}, {a, 3 + b, 3 + c}, {3 + b, c, 3 + c}};
  return {{a, b, 3 + c}, {b, 3 + b, 3 + c}, {3 + b, c, 3 + c}};
}

}  // namespace handwheel
