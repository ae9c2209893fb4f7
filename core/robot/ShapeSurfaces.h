// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/TriangleSoup.h"
#include "robot/RobotModel.h"

namespace handwheel {

// Into how many sides round shapes are cut: the setting cell.shape_sides, and its default.
inline constexpr std::uint32_t kShapeSides = 48;
inline constexpr std::uint32_t kLeastShapeSides = 4;

// The surface of a shape in mm, closed and with the faces turned outwards; empty for a mesh, which is in a file. Round
// shapes are cut into so many sides around, a ball into half as many belts: with 48 within 0.5 % of the radius.
// O(sides) triangles for a cylinder, O(sides^2) for a ball.
TriangleSoup surfaceOf(const Shape& shape, std::uint32_t sides = kShapeSides);

// The points of a mesh file, in metres, placed as a shape wants them: scaled, in mm; turned over where the scale
// mirrors.
void place(const MeshShape& shape, TriangleSoup& soup);

}  // namespace handwheel
