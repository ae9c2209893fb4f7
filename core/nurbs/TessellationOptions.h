// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace handwheel {

struct TessellationOptions {
  // mm: no triangle leaves the surface further than this.
  double chord = 0.01;
  // How many chords of its circles long a triangle of the mantle may be; a longer one is divided as long as there are
  // no more triangles than these. In the flat ends no angle is below 20°.
  double aspect = 8.0;
  std::uint64_t shapelyTriangles = 100'000;
  // More are refused.
  std::uint64_t mostTriangles = 4'000'000;

  static constexpr double kLargestChord = 1e6;
};

}  // namespace handwheel
