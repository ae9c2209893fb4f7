// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <vector>

namespace handwheel {

// One of the faces around a vertex.
struct FaceAtVertex {
  Vec3 normal;   // of length 1, or zero for a degenerate face
  double angle;  // of its corner at the vertex, radian
};

// A direction that lies behind planes.
struct DirectionBehind {
  Vec3 direction = Vec3::Zero();  // of length 1; zero where none is behind all planes
  double margin = 0.0;            // the least cosine between it and the reversed normals
};

// The direction with the largest margin behind planes with these normals. It points from the point of the normals'
// convex hull that is nearest to the origin (Gilbert, Johnson, Keerthi, "A fast procedure for computing the distance
// between complex objects in three-dimensional space", 1988). None where the margin is below a thousandth. Normals of
// length zero are ignored. O(n) for each of a few steps.
DirectionBehind widestBehind(std::vector<Vec3> normals);

// The offset of a vertex for which every plane of its faces goes back by one, opposite to the normals.
// It is least squares where there are more than three planes, and the smallest such offset where there are fewer, so
// that a sheet with sharp edges has the same thickness on both sides of them. Where that is longer than a mitre may be,
// or leaves one of the faces on its other side, the offset is widestBehind(). Zero where there is none.
Vec3 offsetBehind(const std::vector<FaceAtVertex>& faces);

}  // namespace handwheel
