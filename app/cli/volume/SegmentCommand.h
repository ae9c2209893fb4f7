// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// Returns the command "handwheel segment". It makes a volume or surface from a range of image values.
Command segmentCommand();

}  // namespace handwheel
