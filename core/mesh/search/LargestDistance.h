// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/SurfaceDistance.h"

#include <optional>

namespace handwheel {

// By how much, relatively, the result of largestDistance() may exceed the exact distance.
inline constexpr double kLargestDistanceSlack = 0.01;

// Returns an upper bound of the Hausdorff distance between two surfaces, mm: no point of either is farther from the
// other one, up to the rounding of coordinates. The bound exceeds the exact distance by at most kLargestDistanceSlack,
// except where the surfaces need more parts than the budget allows; there it is larger, never too small. Returns
// nothing if a surface has no triangles, or if cancelled.
//
// Each face is cut into convex parts until a part is proven to be near enough: either because it is small (the distance
// grows no faster than the way), or because its corners are near one triangle of the other surface, to which the
// distance is a convex function (after Tang, Lee, Kim, "Interactive Hausdorff distance computation for general
// polygonal models", 2009). Parts larger than their nearest triangle are halved; others are cut along the planes
// through the edges of that triangle, so that surfaces which coincide in other triangles need about as many parts as
// they have triangles. The result is the same for any number of threads.
std::optional<double> largestDistance(const SurfaceDistance& a, const SurfaceDistance& b, Progress progress = {});
std::optional<double> largestDistance(const HalfEdgeMesh& a, const HalfEdgeMesh& b, Progress progress = {});

}  // namespace handwheel
