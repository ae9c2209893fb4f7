// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/RobotCellSnapshot.h"

#include <optional>

namespace handwheel {

// Returns the bounds of a body at its pose. They are computed from the bounds of its shape.
Box boundsOf(const Body& body);

// Returns the displacement, mm, that moves an object in front of the robots and of all bodies, onto the floor of the
// cell. own: the bounds of the object, in the frame of the root. robots: the bounds of the robots at rest, in the same
// frame. but: a body that is ignored. O(bodies).
Vec3 displacementBeside(const Box& own, const Box& robots, const RobotCellSnapshot& cell,
                        std::optional<BodyId> but = {});

// Returns true if an object is inside a link of the robots at their present joint values, or inside a body. Their
// bounding boxes are compared. An object larger than the robots at rest counts as a room or a table: it is never inside
// another object, and objects inside it do not count. O(points of the robots + bodies).
bool isInsideOthers(const Box& own, const Box& robots, const RobotCellSnapshot& cell);

}  // namespace handwheel
