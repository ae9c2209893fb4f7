// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/surface/MarchingCubesTable.h"

#include <algorithm>
#include <cassert>

namespace handwheel {
namespace {

using Polygon = std::vector<int>;  // edges
using Triangles = std::vector<MarchingCubesTable::EdgeTriangle>;

int edgeBetween(int a, int b) {
  for (int e = 0; e < 12; ++e)
    if (const auto corners = cornersOfCellEdge(e);
        (corners[0] == a && corners[1] == b) || (corners[0] == b && corners[1] == a))
      return e;
  return -1;
}

// The corners of a face, counter-clockwise from outside the cell. Face f is across axis f / 2, at the low end if f is
// even.
std::array<int, 4> cornersOfFace(int face) {
  const int axis = face / 2, u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
  const int base = (face & 1) << axis;
  if (face & 1) return {base, base | u, base | u | v, base | v};
  return {base, base | v, base | u | v, base | u};
}

bool isOnFace(int edge, int face) {
  const auto corners = cornersOfCellEdge(edge);
  return (corners[0] >> face / 2 & 1) == (face & 1) && (corners[1] >> face / 2 & 1) == (face & 1);
}

// The polygon edges on a face as from-to pairs of cell edges, material on the right seen from outside: each run of
// corners inside is cut off by one. So opposite corners inside are separated.
std::vector<std::array<int, 2>> segmentsOnFace(int inside, int face) {
  const auto corners = cornersOfFace(face);
  const auto isInside = [&](int k) { return (inside >> corners[static_cast<std::size_t>(k & 3)] & 1) != 0; };
  const auto crossed = [&](int k) {
    return edgeBetween(corners[static_cast<std::size_t>(k & 3)], corners[static_cast<std::size_t>((k + 1) & 3)]);
  };
  std::vector<std::array<int, 2>> segments;
  for (int k = 0; k < 4; ++k) {
    if (isInside(k) || !isInside(k + 1)) continue;  // a run begins at k + 1
    int last = k + 1;
    while (isInside(last + 1)) ++last;
    segments.push_back({crossed(k), crossed(last)});
  }
  return segments;
}

// The closed polygons between inside and outside.
std::vector<Polygon> polygonsOf(int inside) {
  std::array<int, 12> next;
  next.fill(-1);
  for (int face = 0; face < 6; ++face)
    for (const auto& segment : segmentsOnFace(inside, face)) next[static_cast<std::size_t>(segment[0])] = segment[1];
  std::vector<Polygon> polygons;
  for (int e = 0; e < 12; ++e) {
    Polygon polygon;
    for (int at = e; next[static_cast<std::size_t>(at)] >= 0;) {
      polygon.push_back(at);
      const int to = next[static_cast<std::size_t>(at)];
      next[static_cast<std::size_t>(at)] = -1;
      at = to;
    }
    if (!polygon.empty()) polygons.push_back(polygon);
  }
  return polygons;
}

bool shareAFace(int edge, int other) {
  for (int face = 0; face < 6; ++face)
    if (isOnFace(edge, face) && isOnFace(other, face)) return true;
  return false;
}

// The fan of a polygon from its first corner whose diagonals lie in no face, where those of the next cell could lie,
// too. There is one for each polygon of the table.
Triangles fanOf(Polygon polygon) {
  const std::size_t n = polygon.size();
  const auto isClear = [&] {
    for (std::size_t k = 2; k + 1 < n; ++k)
      if (shareAFace(polygon.front(), polygon[k])) return false;
    return true;
  };
  for (std::size_t i = 0; i < n && !isClear(); ++i) std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
  assert(isClear());
  Triangles fan;
  for (std::size_t k = 1; k + 1 < n; ++k)
    fan.push_back({static_cast<std::uint8_t>(polygon.front()), static_cast<std::uint8_t>(polygon[k]),
                   static_cast<std::uint8_t>(polygon[k + 1])});
  return fan;
}

}  // namespace

std::array<int, 2> cornersOfCellEdge(int edge) {
  const int axis = edge / 4, others = edge & 3;
  int low = 0;
  for (int k = 0, bit = 0; k < 3; ++k)
    if (k != axis) low |= (others >> bit++ & 1) << k;
  return {low, low | 1 << axis};
}

const MarchingCubesTable& MarchingCubesTable::table() {
  static const MarchingCubesTable made = [] {
    MarchingCubesTable table;
    for (int inside = 0; inside < 256; ++inside)
      for (const Polygon& polygon : polygonsOf(inside))
        for (const auto& t : fanOf(polygon)) table.triangles[static_cast<std::size_t>(inside)].push_back(t);
    return table;
  }();
  return made;
}

}  // namespace handwheel
