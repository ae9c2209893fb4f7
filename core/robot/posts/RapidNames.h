// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/program/RobotProgram.h"

namespace handwheel {

// The largest length of names in RAPID. These names are not case-sensitive.
inline constexpr std::size_t kLongestRapidName = 32;

// Returns the name of the procedure of a path. It leaves room for the suffixes of modules, and is no name of the
// language or a controller. A number is added if another path of the cell, or its module, would have the same name,
// regardless of case: two programs may be loaded into one task.
std::string rapidName(const RobotProgram& program);

// Returns the name of the frame of a program. A frame of the cell keeps its name for all paths, with the prefix "wobj_"
// if a path of the cell, its module or the controller uses the name. If the frame is none of the cell, its name is that
// of the path with the suffix "_frame".
std::string rapidFrameName(const RobotProgram& program);

// Returns the names that programs may have for the frame program.frameName of a cell, whatever the names of the paths.
std::vector<std::string> rapidFrameNames(const RobotProgram& program);

}  // namespace handwheel
