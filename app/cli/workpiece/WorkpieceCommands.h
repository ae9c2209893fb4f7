// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// Returns the commands for workpieces, such as 'turn', 'train' and 'force'.
std::vector<Command> workpieceCommands();

// Runs the command 'turn', which cuts a workpiece by a program or a recording, or repeats its passes and compares the
// result with the part. Returns the exit code.
int runTurn(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
