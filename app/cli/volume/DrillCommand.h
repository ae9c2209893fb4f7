// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// "handwheel drill": drills a part along the recorded path of a head.
Command drillCommand();

}  // namespace handwheel
