// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/SurfaceDistance.h"

namespace handwheel {

// The results of liesWithin().
enum class Within {
  Yes,      // proven for every point of the surface, including those between the samples
  No,       // a point is farther away
  Unknown,  // not decided within the allowed number of steps, or cancelled
};

// The relative resolution of distances. No may be returned although all points are within the limit, if a point is
// nearer to the limit than this fraction of it. Yes is never returned if a point is farther than the limit.
inline constexpr double kBoundSlack = 0.01;

// Tests if every point of one surface is within a distance of the other surface. The distance is in mm, above zero.
// Triangles are cut into four until all three corners of a part are within that distance of the same triangle of the
// other surface, to which the distance is a convex function, or until the part is smaller than the margin that remains
// at its middle between the actual and the allowed distance (after Tang, Lee, Kim, "Interactive Hausdorff distance
// computation for general polygonal models", 2009). The test runs on all threads of the arena; the time grows with the
// edge length of the other surface divided by the distance. If beyond is given, all faces are examined, and beyond
// receives one point for each face with points that are too far away, sorted.
Within liesWithin(const SurfaceDistance& surface, const SurfaceDistance& of, double distance, Progress progress = {},
                  std::vector<Vec3>* beyond = nullptr);

}  // namespace handwheel
