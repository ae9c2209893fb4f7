// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace handwheel {

// The marching cubes table (Lorensen and Cline 1987), with ambiguous faces resolved. Surfaces are closed and manifold
// and do not intersect: where a face of a cell has material in two opposite corners only, they are separated, from both
// sides; and no diagonal lies in a face, where one of the next cell could lie.
//
// Corner c of a cell is at (c & 1, c >> 1 & 1, c >> 2). Edge e is along axis e / 4, from the corner whose other two
// coordinates, in the order of the axes, are e & 1 and e >> 1 & 1.
struct MarchingCubesTable {
  using EdgeTriangle = std::array<std::uint8_t, 3>;  // edges with its corners; counter-clockwise from outside

  std::array<std::vector<EdgeTriangle>, 256> triangles;  // by the corners inside: bit c is corner c

  // Made once. Thread-safe.
  static const MarchingCubesTable& table();
};

// Where the surface crosses an edge with these depths at its ends, as a share of it: away from the ends, so that
// triangles keep an area when their points are rounded to single precision.
inline double shareToSurface(double from, double to) {
  constexpr double kLeast = 0.01;
  return std::clamp(from / (from - to), kLeast, 1.0 - kLeast);
}

// The corners of an edge, the lower first.
std::array<int, 2> cornersOfCellEdge(int edge);

}  // namespace handwheel
