// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"
#include "document/Operation.h"

namespace handwheel {

// Returns the commands for exercises, which are 'exercise' and 'mark'.
std::vector<Command> exerciseCommands();

// Returns the operation of the command 'exercise'. One of its parameters selects the action.
const Operation& exerciseOperation();

}  // namespace handwheel
