// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"

#include <optional>

namespace handwheel {

// A flat face of a displayed part.
struct FlatFace {
  Vec3 point = Vec3::Zero();    // A point on the face, such as the one under the pointer
  Vec3 normal = Vec3::UnitZ();  // Unit length, pointing away from the part
  Vec3 middle = Vec3::Zero();   // Centroid of the flat piece of surface around the point
};

// Returns the face of a displayed part at a position on it. All data are in the frame of the model. Returns nothing if
// there is no triangle with an area near the position. O(triangles). isWhole: the flat piece is followed across edges
// that bend by less than a tenth of a degree; otherwise `middle` is the position.
std::optional<FlatFace> faceAt(const DisplayPart& part, const Vec3& position, bool isWhole);

// Returns the motion, in the frame of the model, that moves one face onto another. The smallest rotation makes the
// normals opposed, the points meet with `offset` (mm) between them, and the part is turned about the normal by `angle`
// (rad).
Pose bringingTogether(const Vec3& point, const Vec3& normal, const Vec3& onto, const Vec3& ontoNormal, double offset,
                      double angle);

}  // namespace handwheel
