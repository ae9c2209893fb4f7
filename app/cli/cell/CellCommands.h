// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// Returns all commands of the command line for robot cells.
std::vector<Command> cellCommands();

}  // namespace handwheel
