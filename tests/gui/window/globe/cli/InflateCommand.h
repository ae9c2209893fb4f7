// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel::test {

// The command of globes: handwheel inflate.
Command inflateCommand();

}  // namespace handwheel::test
