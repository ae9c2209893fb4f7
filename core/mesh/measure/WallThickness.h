// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/FaceHierarchy.h"

#include <optional>

namespace handwheel {

// The wall thickness of a body at a surface point, by two common measures. Lengths in mm.
struct WallThickness {
  double alongNormal = 0.0;  // to the wall behind, straight inwards
  Vec3 opposite = Vec3::Zero();
  // The diameter of the largest ball inside that touches the surface there: never more than along the normal, and less
  // where the walls run together or a third one is near.
  double ballDiameter = 0.0;
  Vec3 ballCentre = Vec3::Zero();
};

// Computes the wall thickness at a point of a live face. It is measured inwards along its smoothNormal(). Along it,
// parts that run into each other are one body; the ball meets every wall. It shrinks from the one between the two walls
// until none of the surface is inside by more than 1 % of its radius and the deviation of the facets from the smooth
// surface (Ma, Bae, Choi, "3D medial axis point approximation using nearest neighbors and the normal field", 2012, on
// the surface instead of a cloud of points); so what is rougher than that makes it small. None where there is no wall
// behind, as on an open sheet, or the face has no area.
std::optional<WallThickness> wallThickness(const FaceHierarchy& faces, Face f, const Vec3& p);

}  // namespace handwheel
