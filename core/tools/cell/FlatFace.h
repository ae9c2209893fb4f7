// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"

#include <optional>

namespace handwheel {

// A face of a part under the pointer.
struct FlatFace {
  Vec3 point = Vec3::Zero();    // The point under the pointer, on the face
  Vec3 normal = Vec3::UnitZ();  // Away from the part, of unit length
  Vec3 middle = Vec3::Zero();   // Centroid of the flat piece of surface around the point
};

// Returns the face of a displayed part at a position on it; all in the frame of the model. Nothing if the part has no
// triangle with an area near it. O(triangles). isWhole: follow the flat piece across edges that bend by less
// than a tenth of a degree; otherwise `middle` is that position.
std::optional<FlatFace> faceAt(const DisplayPart& part, const Vec3& position, bool isWhole);

// Returns the motion, in the frame of the model, that brings one face onto another: normals opposed, the points meet
// with `offset` (mm) between them, by the smallest rotation, then turned about the normal by `angle` (rad).
Pose bringingTogether(const Vec3& point, const Vec3& normal, const Vec3& onto, const Vec3& ontoNormal, double offset,
                      double angle);

}  // namespace handwheel
