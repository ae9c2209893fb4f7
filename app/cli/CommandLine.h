// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// Returns true if the first argument is a subcommand, or requests help or the version.
bool isCommand(int argc, char** argv, const Registered& registered);

// Runs the command and returns its exit code (Messages.h). Errors are reported on stderr.
int runCommand(int argc, char** argv, const Registered& registered);

}  // namespace handwheel
