// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace handwheel {

// Options of tessellate().
struct TessellationOptions {
  // Largest distance of a triangle from the surface, mm.
  double chord = 0.01;
  // The largest length of a triangle of the lateral surface, as a multiple of the chords of its circles. Longer
  // triangles are divided, unless that gives more than maxWellShapedTriangles triangles. In the flat ends no angle is
  // below 20°.
  double aspect = 8.0;
  std::uint64_t maxWellShapedTriangles = 100'000;
  // Limit of the number of triangles; more are refused.
  std::uint64_t mostTriangles = 4'000'000;

  static constexpr double kLargestChord = 1e6;
};

}  // namespace handwheel
