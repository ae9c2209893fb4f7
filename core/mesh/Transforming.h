// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "base/Tolerance.h"
#include "base/Units.h"
#include "mesh/HalfEdgeMesh.h"

#include <optional>

namespace handwheel {

// Moves, turns, scales or mirrors all vertices that live faces use. A mirrored mesh has its faces turned, so that they
// look to the same side of the surface as before. Errors: ValueOutOfRange {"determinant", …} where the transform
// flattens or is not finite, {"coordinate", …} where a result is not finite; then nothing changes. O(n).
Status transform(HalfEdgeMesh& mesh, const Eigen::Affine3d& by);

// Turns every face over, in place.
void turnOver(HalfEdgeMesh& mesh);

// By how much to multiply what was written in one unit but read as another.
constexpr double unitScale(LengthUnit written, LengthUnit readAs) {
  return millimetresPer(written) / millimetresPer(readAs);
}

// The moves below bring the mesh to a place; transform() makes them. None where the mesh has no area, or its
// coordinates are too large to tell.

// Turns the surface's principal axes onto x, y and z, the longest onto x, and its centre of area into the origin. Each
// axis points to where the surface reaches farther (by the third moment); the third follows from the others.
std::optional<Pose> ontoPrincipalAxes(const HalfEdgeMesh& mesh);

// Puts the largest flat face that the body can stand on onto the plane z = 0, the body above, its box centred over the
// origin. A flat face is all faces in one plane, wherever in it; the body can stand on one when nothing is below it.
// flatness: share of the box's diagonal; how far points may be from the plane. None where there is no such face of at
// least this share of the area. Only the planes of the 64 largest connected flat regions are looked at.
struct Resting {
  double flatness = tolerance::kStandingFlatness;
  double leastShare = tolerance::kStandingShare;
};
std::optional<Pose> ontoLargestFlatFace(const HalfEdgeMesh& mesh, const Resting& resting = {}, Progress progress = {});

// Moves a point of the bounding box into the origin: 0 is its low side, 0.5 its middle, 1 its high side, for each axis.
std::optional<Pose> boxToOrigin(const HalfEdgeMesh& mesh, const Vec3& anchor);

}  // namespace handwheel
