// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// The clearance that paths of robots with simplified shapes begin with, mm. By how much the shapes of the library are
// smaller than the robots is known of none, and more than this in places (the shoulder of a UR): it does not make up
// for that, but for how exactly a robot and what stands around it are placed, and it reminds of choosing one.
inline constexpr double kPlainShapesClearance = 5.0;

// The default clearance of a new path of the robot that is planned for, mm: that of the cell; without one, for a robot
// of the library that has simplified shapes, kPlainShapesClearance.
double defaultClearance(const CellRobot& robot, const CellPlans& plans);

// The same for a path whose tool works so far from its part (mm, 0 or less: in it): at most half of that, so that what
// the robot carries does not count as too near to the part.
double defaultClearance(const CellRobot& robot, const CellPlans& plans, double standoff);

}  // namespace handwheel
