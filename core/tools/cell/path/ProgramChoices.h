// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/program/RobotPath.h"

namespace handwheel {

// Decisions about a path of a program, before it is verified or exported.
struct ProgramChoices {
  bool cornersAsStops = false;  // the robot stops exactly where the program has a rounding (CNT)
  bool withoutLines = false;    // lines that are not interpreted are left out, but for comments
  bool keepsCarried = false;    // the robot carries after all lines what it carried before

  bool operator==(const ProgramChoices&) const = default;
};

// Returns the path with these choices.
RobotPath chosen(RobotPath path, const ProgramChoices& choices);

// Returns the numbers of the lines that chosen() leaves out and a robot would execute, each once, in rising order.
std::vector<std::size_t> linesLeftOut(const RobotPath& path, const ProgramChoices& choices);

}  // namespace handwheel
