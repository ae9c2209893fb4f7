// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/FaceHierarchy.h"

#include <optional>

namespace handwheel {

// The wall thickness of a body at a surface point, by two common measures. Lengths are in mm.
struct WallThickness {
  double alongNormal = 0.0;  // distance to the opposite wall, straight inwards
  Vec3 opposite = Vec3::Zero();
  // The diameter of the largest ball inside the body that touches the surface at the point. It is at most alongNormal,
  // and less if the walls converge or a third one is near.
  double ballDiameter = 0.0;
  Vec3 ballCentre = Vec3::Zero();
};

// Computes the wall thickness at a point of a live face. It is measured inwards along the smooth normal of the face at
// the point (smoothNormal()). Along the normal, overlapping parts count as one body; the ball respects every wall. At
// first the ball touches the two walls. It shrinks until the surface reaches into it by no more than 1 % of its radius
// plus the deviation of the facets from the smooth surface; if the surface is rougher than that, the ball becomes too
// small. The method is that of Ma, Bae and Choi, "3D medial axis point approximation using nearest neighbors and the
// normal field", 2012, applied to the surface instead of a cloud of points. Returns nothing if there is no opposite
// wall, as on an open sheet, or if the face has no area.
std::optional<WallThickness> wallThickness(const FaceHierarchy& faces, Face f, const Vec3& p);

}  // namespace handwheel
