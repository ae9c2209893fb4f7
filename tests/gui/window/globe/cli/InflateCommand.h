// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel::test {

// Returns the command "handwheel inflate", which changes globes.
Command inflateCommand();

}  // namespace handwheel::test
