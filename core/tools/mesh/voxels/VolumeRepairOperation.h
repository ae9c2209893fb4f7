// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"

namespace handwheel {

// Returns the description of a repair by a volume.
const Operation& volumeRepairOperation();

}  // namespace handwheel
