// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace handwheel {

// Returns the path of the running executable, for starting this program again.
std::string ownProgram();

// Runs a program found along PATH, waits for it and returns its exit code: 127 if there is no such program, 128 + n if
// signal n ended it. The program shares stdout and stderr with this process. It inherits the end of a pipe that closes
// when this process receives a signal or ends, for any reason. A program that called endWithParent() then ends, even if
// other programs such as xvfb-run started it, so that these can clean up after it. After a signal, programs that do not
// end are killed.
int runChild(const std::vector<std::string>& words);

// Sends SIGTERM to this process when the process whose runChild() started it ends, even if other programs are in
// between. Does nothing if this process was started otherwise. Must be called after watchSignals().
void endWithParent();

}  // namespace handwheel
