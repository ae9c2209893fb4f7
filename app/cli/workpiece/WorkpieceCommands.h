// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// The commands for workpieces: turn, train and force.
std::vector<Command> workpieceCommands();

// Cuts a workpiece along a recorded path of the tool, or repeats its passes and compares. Returns the exit code.
int runTurn(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
