// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// The command "force": the forces of a cut by each law, and broken rules.
Command forceCommand();

}  // namespace handwheel
