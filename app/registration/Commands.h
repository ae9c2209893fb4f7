// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// All commands for one kind of document only. The one place to add further ones.
std::vector<Command> registeredCommands();

}  // namespace handwheel
