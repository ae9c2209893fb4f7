// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace handwheel {

// Returns the path of the running executable, for starting it again.
std::string ownProgram();

// Runs a program found along PATH and waits for it. It shares our stdout and stderr. It holds the end of a pipe that
// closes when a signal arrives or this process ends, for any reason; a program that called endWithParent() then ends,
// also if it runs below others such as xvfb-run, which can thus clean up after it. Those that do not end are killed.
// Returns its exit code, 127 if there is no such program, 128 + n if signal n ended it.
int runChild(const std::vector<std::string>& words);

// Makes the end of the parent process arrive as SIGTERM from now on. For a program that runChild() of another one
// started, even indirectly; does nothing in others. Must be called after watchSignals().
void endWithParent();

}  // namespace handwheel
