// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// Returns the command "handwheel drill", which drills a part along a recorded path.
Command drillCommand();

}  // namespace handwheel
