// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"

namespace handwheel {

// Returns the descriptions of strokes and of the other changes of a patch (sculpt/SculptScript.h).
std::vector<Operation> sculptOperations();

}  // namespace handwheel
