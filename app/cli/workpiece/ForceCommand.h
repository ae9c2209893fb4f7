// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// Returns the command "force". It calculates the forces of a cut by each law and by a trained network, and lists the
// rules of cutting that the cut breaks.
Command forceCommand();

}  // namespace handwheel
