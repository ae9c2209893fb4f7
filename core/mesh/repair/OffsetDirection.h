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

// The offset of a vertex for which every plane of its faces goes back by one, opposite to the normals.
// It is least squares where there are more than three planes, and the smallest such offset where there are fewer, so
// that a sheet with sharp edges has the same thickness on both sides of them. Where that is longer than a mitre may be,
// or leaves one of the faces on its other side, the offset has length one and a direction behind all faces: against
// their mean normal, or, where one of them faces the other way in a sharp fold, against the middle of the smallest ball
// around the normals. Zero where there is none.
Vec3 offsetBehind(const std::vector<FaceAtVertex>& faces);

}  // namespace handwheel
