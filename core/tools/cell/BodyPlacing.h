// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/RobotCellSnapshot.h"

#include <optional>

namespace handwheel {

// The bounds of a body at its place, from those of its shape.
Box boundsOf(const Body& body);

// How far something is to be moved to stand in front of the robots and of all bodies but one, on the floor of the cell;
// mm. own, robots: bounds, in the frame of the root; of robots at rest. O(bodies).
Vec3 wayBeside(const Box& own, const Box& robots, const RobotCellSnapshot& cell, std::optional<BodyId> but = {});

// Whether something is inside a link of the robots as they stand, or inside a body, as far as their boxes tell. What is
// larger than the robots at rest is a room or a table: it is inside nothing, and other things stand in it. O(points of
// the robots + bodies).
bool isInsideOthers(const Box& own, const Box& robots, const RobotCellSnapshot& cell);

}  // namespace handwheel
