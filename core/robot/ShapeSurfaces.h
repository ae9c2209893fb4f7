// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"
#include "robot/RobotModel.h"

namespace handwheel {

// The default number of sides of round shapes: the setting cell.shape_sides.
inline constexpr std::uint32_t kShapeSides = 48;
inline constexpr std::uint32_t kLeastShapeSides = 4;

// Tessellates a shape into a closed surface that faces outwards, in mm. Empty for a mesh, which is in a file. Round
// shapes have this many sides, a ball half as many bands: with 48 within 0.5 % of the radius. O(sides) triangles for a
// cylinder, O(sides²) for a ball.
TriangleSoup surfaceOf(const Shape& shape, std::uint32_t sides = kShapeSides);

// Applies the scale of a mesh shape to the mesh of its file. The points, in metres, become mm; faces are reversed if
// the scale mirrors.
void place(const MeshShape& shape, TriangleSoup& soup);

}  // namespace handwheel
