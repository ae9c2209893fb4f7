// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/CommandLine.h"
namespace handwheel { bool isCommand(int, char**) { return false; } int runCommand(int, char**) { return 1; } }
