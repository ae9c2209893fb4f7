// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/SurfaceDistance.h"

#include <optional>
#include <span>
#include <vector>

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

// The result of proveWithin().
struct DistanceProof {
  double bound = 0.0;        // mm, as of largestDistance(), for the faces without points beyond the limit
  std::vector<Vec3> beyond;  // a point of each face that has points too far from the other surface, or may, sorted

  bool isWithin(double limit) const { return beyond.empty() && bound <= limit; }
};

// Proves that two surfaces are within a limit (mm) of each other, or finds where they are not. A point nearer to the
// limit than kLargestDistanceSlack may count as too far. regions: if there are any, only faces whose boxes meet one of
// these boxes are tested; for a surface that was changed since the last proof, they are the boxes of the faces that
// were changed and of those that were made, enlarged by the limit. Returns nothing as largestDistance() does.
std::optional<DistanceProof> proveWithin(const SurfaceDistance& a, const SurfaceDistance& b, double limit,
                                         Progress progress = {}, std::span<const Box> regions = {});

}  // namespace handwheel
