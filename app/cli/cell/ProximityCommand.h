// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// Returns the command "proximity", which measures the distance queries of a cell.
Command proximityCommand();

}  // namespace handwheel
