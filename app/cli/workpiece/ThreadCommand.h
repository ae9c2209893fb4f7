// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// The command "thread": cuts a thread into a workpiece.
Command threadCommand();

}  // namespace handwheel
