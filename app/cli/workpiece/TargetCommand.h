// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// Returns the command "target". The target of a workpiece is the part to be turned. The command reads a target from
// STEP, DXF, SVG or a workpiece, lists its dimensions, measures a workpiece against it, draws it, or sets it as the
// target of a workpiece.
Command targetCommand();
// Runs the command "target" and returns the exit code.
int runTarget(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
