// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// The command force: the forces of a cut by each law, and the rules that it breaks.
Command forceCommand();

}  // namespace handwheel
