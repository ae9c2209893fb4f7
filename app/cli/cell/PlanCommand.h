// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// The command "plan": plans a collision-free path of a robot in a cell.
Command planCommand();

}  // namespace handwheel
