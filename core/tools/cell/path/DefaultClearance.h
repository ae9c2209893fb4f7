// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// Initial clearance of paths of robots with simplified shapes, mm. The simplified shapes of the library are smaller
// than the robots by an unknown distance, which locally exceeds this clearance (the shoulder of a UR). The clearance
// does not compensate for this difference, but for the inaccurate positions of a robot and its surroundings, and it
// reminds the user to choose a clearance.
inline constexpr double kPlainShapesClearance = 5.0;

// Returns the default clearance of a new path of the robot that is planned for, mm: the clearance of the cell, or, if
// that is 0 and the robot has simplified shapes of the library, kPlainShapesClearance.
double defaultClearance(const CellRobot& robot, const CellPlans& plans);

// Returns the default clearance of a new path whose tool keeps a distance from its part. If the cell has no clearance,
// the result is at most half of this distance, so that objects that the robot carries do not count as too close to the
// part. standoff: the distance, mm; 0 or less: the tool is inside the part.
double defaultClearance(const CellRobot& robot, const CellPlans& plans, double standoff);

}  // namespace handwheel
