// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"
#include "document/Operation.h"

namespace handwheel {

// The commands for exercises: exercise, mark.
std::vector<Command> exerciseCommands();

// The operation of the command 'exercise', with its parameters, one of which selects the action.
const Operation& exerciseOperation();

}  // namespace handwheel
