// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// Returns the command "ik". It finds joint values for a pose of a robot's flange.
Command ikCommand();

}  // namespace handwheel
