// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"

#include <optional>
#include <utility>

namespace handwheel {

inline constexpr double kEquilateralArea = 0.4330127018922193;  // area of the equilateral triangle of side 1

// The parameters of remeshEvenly().
struct EvenRemeshing {
  // Wanted lengths of the edges at the first points of the patch, which are those on its border, mm. Inside the patch
  // the wanted length is interpolated.
  std::vector<double> lengths;
  double growth = 0.0;  // by how much the wanted length grows for each millimetre from the border
  // Pairs of border points, smaller index first and sorted, that no new edge may join because an edge outside of the
  // patch does.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joined = {};
  std::size_t mostPoints = 0;  // largest number of points inside the patch
};

// Estimates the number of triangles if the wanted lengths at the first points hold everywhere.
double expectedTriangles(const TriangleSoup& patch, const std::vector<double>& lengths);

// Remeshes a patch so that its triangles become as equilateral as its border allows: long edges are split, short ones
// are collapsed, edges are flipped to enlarge the angles, and points inside move to the middle of their neighbours and
// back to the given surface (Botsch and Kobbelt, "A remeshing approach to multiresolution modeling", 2004). The border
// points stay the first points of the result, where they are, and the edges of the border stay. Returns nothing if the
// patch is not manifold, if a vertex has more than tolerance::kLibraryFanFaces faces, or if cancelled. O(points of the
// result, times the logarithm of the triangles of the patch).
std::optional<TriangleSoup> remeshEvenly(const TriangleSoup& patch, const EvenRemeshing& wanted,
                                         Progress progress = {});

}  // namespace handwheel
