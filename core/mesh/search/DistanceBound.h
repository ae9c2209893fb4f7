// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/SurfaceDistance.h"

namespace handwheel {

// The answers of liesWithin().
enum class Within {
  Yes,      // proven for every point of the surface, between the samples too
  No,       // a point is farther
  Unknown,  // too near to call within the steps allowed, or cancelled
};

// The relative resolution of distances: where a point is nearer than the limit by less than this share, No may be
// answered all the same, never Yes where one is farther.
inline constexpr double kBoundSlack = 0.01;

// Whether every point of one surface is within a distance of the other. The distance is in mm, above zero. Triangles
// are cut into four until all three corners of a part are within it of one and the same triangle of the other surface,
// to which the distance is a convex function, or until the part is smaller than the margin at its middle (after Tang,
// Lee, Kim, "Interactive Hausdorff distance computation for general polygonal models", 2009). On all threads of the
// arena; the time grows as the length of the other's edges over the distance. beyond: when given, all faces are
// examined, and it gets a place that is farther for each face that has one; sorted.
Within liesWithin(const SurfaceDistance& surface, const SurfaceDistance& of, double distance, Progress progress = {},
                  std::vector<Vec3>* beyond = nullptr);

}  // namespace handwheel
