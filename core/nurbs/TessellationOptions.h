// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace handwheel {

// Options of tessellate().
struct TessellationOptions {
  // mm: no triangle is further from the surface than this.
  double chord = 0.01;
  // The largest length of a triangle of the lateral surface, in chords of its circles; a longer one is divided as long
  // as there are no more triangles than these. In the flat ends no angle is below 20°.
  double aspect = 8.0;
  std::uint64_t maxWellShapedTriangles = 100'000;
  // More triangles are refused.
  std::uint64_t mostTriangles = 4'000'000;

  static constexpr double kLargestChord = 1e6;
};

}  // namespace handwheel
