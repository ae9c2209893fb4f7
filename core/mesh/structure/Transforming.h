// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "base/Tolerance.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <optional>

namespace handwheel {

// Applies an affine transform to all vertices that live faces use. A mirrored mesh has its faces reversed, so that they
// face the same side of the surface as before. Errors: ValueOutOfRange {"determinant", …} where the transform flattens
// or is not finite, {"coordinate", …} where a result is not finite; then nothing changes. O(n).
Status transform(HalfEdgeMesh& mesh, const Eigen::Affine3d& by);

// Reverses the orientation of every face, in place.
void reverseOrientation(HalfEdgeMesh& mesh);

// The functions below compute a rigid motion; transform() applies it. None where the mesh has no area, or its
// coordinates are too large to determine it.

// Aligns the principal axes of the surface with x, y and z. The longest becomes x, and the centre of area the origin.
// Each axis points to where the surface reaches farther (by the third moment); the third follows from the others.
std::optional<Pose> ontoPrincipalAxes(const HalfEdgeMesh& mesh);

// Options of ontoLargestFlatFace(). flatness: share of the box's diagonal; how far points may be from the plane.
// leastShare: of the area, that the flat face must have.
struct FlatBaseOptions {
  double flatness = tolerance::kFlatBaseFlatness;
  double leastShare = tolerance::kFlatBaseShare;
};
// Places a body on the plane z = 0 with its largest flat base. The body is above, its box centred over the origin. A
// flat face is all faces in one plane, wherever in it; it is a base when nothing of the body is below it. None where
// there is no such face of at least leastShare of the area. Only the planes of the 64 largest connected flat regions
// are tested.
std::optional<Pose> ontoLargestFlatFace(const HalfEdgeMesh& mesh, const FlatBaseOptions& resting = {},
                                        Progress progress = {});

// Moves a point of the bounding box into the origin. For each axis, 0 is its low side, 0.5 its middle, 1 its high side.
std::optional<Pose> boxToOrigin(const HalfEdgeMesh& mesh, const Vec3& anchor);

}  // namespace handwheel
