// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// Returns the commands "shell" and "offset", which make volumes by distances from a surface.
std::vector<Command> shellOffsetCommands();

}  // namespace handwheel
