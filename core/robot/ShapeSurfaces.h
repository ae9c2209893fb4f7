// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"
#include "robot/RobotModel.h"

namespace handwheel {

// The default number of sides of round shapes (setting cell.shape_sides).
inline constexpr std::uint32_t kShapeSides = 48;
inline constexpr std::uint32_t kLeastShapeSides = 4;

// Tessellates a shape into a closed surface that faces outwards, in mm. The result is empty for a mesh, which is in a
// file. sides: the number of sides of a round shape; a sphere has half this number of bands. With 48 sides the surface
// is within 0.5 % of the radius. The result has O(sides) triangles for a cylinder and O(sides²) for a sphere.
TriangleSoup surfaceOf(const Shape& shape, std::uint32_t sides = kShapeSides);

// Applies the scale of a mesh shape to the mesh of its file, and converts the points from metres to mm. Faces are
// reversed if the scale mirrors the mesh.
void place(const MeshShape& shape, TriangleSoup& soup);

}  // namespace handwheel
