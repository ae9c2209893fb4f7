// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// The command "train": trains a model of cutting forces on a table of cuts.
Command trainCommand();

}  // namespace handwheel
