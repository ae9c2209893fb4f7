// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// The command that finds joint values for a pose of a robot's flange: handwheel ik.
Command ikCommand();

}  // namespace handwheel
