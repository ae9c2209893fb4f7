// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/RobotCellSnapshot.h"

#include <optional>

namespace handwheel {

// Returns the bounds of a body at its pose, from those of its shape.
Box boundsOf(const Body& body);

// Returns the displacement that brings an object in front of the robots and of all bodies but one, onto the floor of
// the cell; mm. own, robots: bounds in the frame of the root; those of the robots at rest. O(bodies).
Vec3 displacementBeside(const Box& own, const Box& robots, const RobotCellSnapshot& cell,
                        std::optional<BodyId> but = {});

// Returns true if an object is inside a link of the robots at their present joint values, or inside a body, judged by
// their boxes. An object larger than the robots at rest is a room or a table: it is inside nothing, and other objects
// may be inside it. O(points of the robots + bodies).
bool isInsideOthers(const Box& own, const Box& robots, const RobotCellSnapshot& cell);

}  // namespace handwheel
