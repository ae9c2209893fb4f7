// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// The command "target": the target of a workpiece, which is the part to be turned. Reads one from STEP, DXF, SVG or a
// workpiece, lists its dimensions, measures a workpiece against it, draws it, or sets it as the target of a workpiece.
Command targetCommand();
int runTarget(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
