// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// Returns the command "plan", which plans a collision-free path of a robot in a cell.
Command planCommand();

}  // namespace handwheel
