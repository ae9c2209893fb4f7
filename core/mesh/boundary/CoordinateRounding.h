// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

#include <span>

namespace handwheel {

// The distances of neighbouring numbers in a file, in mm.
//
// If all coordinates fit into floats, these are the units in the last place of the largest coordinate of each axis.
// Otherwise they follow from the decimals of the file, for example 0.001 for survey coordinates like 5400000.125.
// Decimals count only if they are small compared to the model, at most 1e-3 of its diagonal: a part drawn on a coarse
// grid is not rounded to it. The steps are 0 if coordinates have all digits of a double, and
// if they end in fewer than four different digits, as those of a grid of halves do.
struct CoordinateSteps {
  Vec3 steps = Vec3::Zero();

  // The largest distance of a rounded vertex from a rounded edge on which it lay, and of two such copies of a point.
  double reach() const { return steps.norm(); }
};

// Finds the steps of these points. O(n).
CoordinateSteps coordinateSteps(std::span<const Vec3> points);
// Finds the steps of the vertices of live faces. O(n).
CoordinateSteps coordinateSteps(const HalfEdgeMesh& mesh);

}  // namespace handwheel
