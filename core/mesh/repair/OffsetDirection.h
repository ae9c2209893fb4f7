// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <vector>

namespace handwheel {

// One of the faces around a vertex.
struct FaceAtVertex {
  Vec3 normal;   // unit length, or zero for a degenerate face
  double angle;  // angle of its corner at the vertex, radian
};

// A direction that lies behind planes.
struct DirectionBehind {
  Vec3 direction = Vec3::Zero();  // unit length; zero if no direction is behind all planes
  double margin = 0.0;            // smallest cosine of the angles to the reversed normals
};

// Returns the direction with the largest margin behind planes with these normals. It is opposite to the point of the
// normals' convex hull that is nearest to the origin (Gilbert, Johnson, Keerthi, "A fast procedure for computing the
// distance between complex objects in three-dimensional space", 1988). The direction is zero if the margin is below a
// thousandth. Normals of length zero are ignored. O(n) for each of a few steps.
DirectionBehind widestBehind(std::vector<Vec3> normals);

// Returns the offset of a vertex that moves every plane of its faces back by one unit, opposite to the normals. It is a
// least-squares solution for more than three planes, and the smallest such offset for fewer, so that a sheet with sharp
// edges has the same thickness on both sides of them. If that offset is longer than two units or is in front of one of
// the faces, widestBehind() is used. Returns zero if there is no such direction.
Vec3 offsetBehind(const std::vector<FaceAtVertex>& faces);

}  // namespace handwheel
