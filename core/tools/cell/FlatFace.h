// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"

#include <optional>

namespace handwheel {

// A face of a part that is pointed to.
struct FlatFace {
  Vec3 point = Vec3::Zero();    // where it is pointed to, on it
  Vec3 normal = Vec3::UnitZ();  // away from the part, of unit length
  Vec3 middle = Vec3::Zero();   // the centroid of the flat piece of surface around the point
};

// The face of a displayed part at a place on it; all in the frame of the model. None where the part has no triangle
// with an area near the place. O(triangles); the flat piece is followed across edges that bend by less than a tenth of
// a degree, and only if it is asked for; else `middle` is the point.
std::optional<FlatFace> faceAt(const DisplayPart& part, const Vec3& place, bool isWhole);

// The pose that brings one face onto another by a motion of the frame of the model: normals opposed, the points meet
// with `offset` (mm) between them, by the smallest turn, then turned about the normal by `angle` (rad).
Pose bringingTogether(const Vec3& point, const Vec3& normal, const Vec3& onto, const Vec3& ontoNormal, double offset,
                      double angle);

}  // namespace handwheel
