// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// Returns the commands of the command line for volumes.
std::vector<Command> volumeCommands();

}  // namespace handwheel
