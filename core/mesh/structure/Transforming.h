// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "base/Tolerance.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <optional>

namespace handwheel {

// Applies an affine transform to all vertices that live faces use. If the transform mirrors, faces are reversed, so
// that they face the same side of the surface as before. Errors: ValueOutOfRange {"determinant", …} if the transform
// flattens or is not finite, {"coordinate", …} if a result is not finite. In case of an error, the mesh is unchanged.
// O(n).
Status transform(HalfEdgeMesh& mesh, const Eigen::Affine3d& by);

// Reverses the orientation of every face, in place.
void reverseOrientation(HalfEdgeMesh& mesh);

// The functions below compute a rigid motion; transform() applies it. They return nothing if the mesh has no area, or
// its coordinates are too large.

// Computes the motion that aligns the principal axes of the surface with x, y and z. The longest axis becomes x, and
// the centre of area the origin. Each axis points to the side on which the surface extends farther (by the third
// moment); the direction of the third axis follows from the other two.
std::optional<Pose> ontoPrincipalAxes(const HalfEdgeMesh& mesh);

// Options of ontoLargestFlatFace(). flatness is the largest distance of points from the plane, as a fraction of the
// box's diagonal. leastShare is the fraction of the area that the flat face must have.
struct FlatBaseOptions {
  double flatness = tolerance::kFlatBaseFlatness;
  double leastShare = tolerance::kFlatBaseShare;
};
// Computes the motion that puts a body on the plane z = 0 with its largest flat base. The body is then above the plane,
// and its box is centred over the origin. A flat face consists of all faces in one plane, connected or not; it is a
// base if no part of the body is below it. Returns nothing if there is no base of at least leastShare of the area. Only
// the planes of the 64 largest connected flat regions are tested.
std::optional<Pose> ontoLargestFlatFace(const HalfEdgeMesh& mesh, const FlatBaseOptions& resting = {},
                                        Progress progress = {});

// Computes the motion of a point of the bounding box to the origin. anchor: the point; for each axis, 0 is the low side
// of the box, 0.5 the middle, and 1 the high side.
std::optional<Pose> boxToOrigin(const HalfEdgeMesh& mesh, const Vec3& anchor);

}  // namespace handwheel
