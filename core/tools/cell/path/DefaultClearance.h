// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// Initial clearance of paths of robots with simplified shapes, mm. It is not known by how much the shapes of the
// library are smaller than the robots, locally by more than this (the shoulder of a UR). The clearance does not make up
// for that, but for the accuracy with which a robot and its surroundings are placed, and it reminds the user to choose
// one.
inline constexpr double kPlainShapesClearance = 5.0;

// Returns the default clearance of a new path of the robot that is planned for, mm: that of the cell; without one, for
// a robot of the library that has simplified shapes, kPlainShapesClearance.
double defaultClearance(const CellRobot& robot, const CellPlans& plans);

// Returns the same for a path whose tool keeps this distance from its part (mm, 0 or less: inside it): at most half of
// it, so that objects which the robot carries do not count as too close to the part.
double defaultClearance(const CellRobot& robot, const CellPlans& plans, double standoff);

}  // namespace handwheel
