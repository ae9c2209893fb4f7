// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// The command segment: a volume, or its surface, of what has certain values in an image.
Command segmentCommand();

}  // namespace handwheel
