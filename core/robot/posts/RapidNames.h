// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/program/RobotProgram.h"

namespace handwheel {

// Names in RAPID. They have at most 32 characters, and the language does not tell cases apart.
inline constexpr std::size_t kLongestRapidName = 32;

// Of the procedure of a path: short enough for what modules add to it, and nothing that the language or a controller
// has. With a number that other names hardly have where another path of the cell would be called the same, whatever the
// case of letters, or its module has that name: both may be loaded into one task.
std::string rapidName(const RobotProgram& program);

// Of the frame that a program is in. A frame of the cell is called as there, whichever path is led in it, with "wobj_"
// before what a path of the cell, its module or the controller calls something else. Another frame has the name of the
// path.
std::string rapidFrameName(const RobotProgram& program);

// The names that programs may have for the frame of a cell which is program.frameName, whatever their paths are called.
std::vector<std::string> rapidFrameNames(const RobotProgram& program);

}  // namespace handwheel
