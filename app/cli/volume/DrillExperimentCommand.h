// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// Returns the command that repeats the reference runs of drilling (DrillExperiments.h).
Command drillExperimentCommand();

}  // namespace handwheel
