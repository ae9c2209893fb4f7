// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// The command "segment": makes a volume or surface of a range of image values.
Command segmentCommand();

}  // namespace handwheel
