// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace handwheel {

// The marching cubes table (Lorensen and Cline 1987), with ambiguous faces resolved. Surfaces are closed, manifold and
// free of self-intersections. If a face of a cell has material only in two opposite corners, both cells at the face
// separate these corners. No diagonal of a polygon lies in a face, where it could meet a diagonal of the next cell.
//
// Corner c of a cell is at (c & 1, c >> 1 & 1, c >> 2). Edge e is along axis e / 4, from the corner whose other two
// coordinates, in the order of the axes, are e & 1 and e >> 1 & 1.
struct MarchingCubesTable {
  using EdgeTriangle = std::array<std::uint8_t, 3>;  // edges on which the corners lie, counter-clockwise from outside

  std::array<std::vector<EdgeTriangle>, 256> triangles;  // indexed by the set of corners inside: bit c is corner c

  // Returns the only instance. May be called on any thread.
  static const MarchingCubesTable& table();
};

// Returns the position of the surface on an edge with these depths at its ends, from 0 to 1. The position is never at
// an end, so that triangles keep an area when their points are rounded to single precision.
inline double shareToSurface(double from, double to) {
  constexpr double kLeast = 0.01;
  return std::clamp(from / (from - to), kLeast, 1.0 - kLeast);
}

// Returns the corners of an edge, the lower one first.
std::array<int, 2> cornersOfCellEdge(int edge);

}  // namespace handwheel
