// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/program/RobotPath.h"

namespace handwheel {

// The time for which the lines of a program let the robot wait.
struct WaitingTime {
  double seconds = 0.0;     // Sum of the waits of given length
  std::size_t unknown = 0;  // Number of lines that wait for something else, as for an input

  bool operator==(const WaitingTime&) const = default;
};

// Returns the waiting time of a path that was read from a program: WaitTime 0.5 (RAPID), WAIT SEC 0.5 (KRL),
// WAIT .50(sec) (Fanuc), sleep(0.5) (URScript).
WaitingTime waitingTimeOf(const RobotPath& path);

}  // namespace handwheel
