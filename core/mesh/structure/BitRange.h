// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace handwheel {

// The positions of the highest and the lowest bit of numbers, as exponents of two.
struct BitRange {
  int high = std::numeric_limits<int>::min(), low = std::numeric_limits<int>::max();

  void extend(double x) {
    if (x == 0.0) return;
    constexpr int kDigits = std::numeric_limits<double>::digits;
    int exponent = 0;
    const auto digits = static_cast<std::uint64_t>(std::ldexp(std::abs(std::frexp(x, &exponent)), kDigits));
    high = std::max(high, exponent);
    low = std::min(low, exponent - kDigits + std::countr_zero(digits));
  }
  int bits() const { return high > low ? high - low : 0; }
};

// Returns the number of bits of the vertex coordinates when written as integers of a common scale. The time of exact
// arithmetic grows with the square of this number.
inline int bitsOf(const HalfEdgeMesh& mesh) {
  BitRange range;
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v) {
    for (const double x : mesh.position(v)) range.extend(x);
  }
  return range.bits();
}

}  // namespace handwheel
