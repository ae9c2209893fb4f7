// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// Returns the command "program", which writes a program for a lathe. The program contains the passes of a workpiece, or
// cycles for a target.
Command programCommand();

}  // namespace handwheel
