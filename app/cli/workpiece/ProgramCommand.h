// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// 'handwheel program': writes the passes of a workpiece, or cycles for a target, as a program for a lathe.
Command programCommand();

}  // namespace handwheel
