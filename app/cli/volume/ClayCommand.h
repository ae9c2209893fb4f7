// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// Returns the command "handwheel clay", which sculpts a part along recorded strokes of a hand.
Command clayCommand();

}  // namespace handwheel
