// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace handwheel {

// The program that is running, for starting it again.
std::string ownProgram();

// Runs a program found along PATH, with our output and our stderr, and waits for it. A signal to us ends it and all it
// started. Returns its exit code, 127 when there is no such program, 128 + n when signal n ended it.
int runChild(const std::vector<std::string>& words);

}  // namespace handwheel
