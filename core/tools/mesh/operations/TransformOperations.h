// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"

namespace handwheel {

// Returns the operations that move, rotate and scale a mesh. The operations use numbers (Placement) or the predefined
// placements (standardPlacements()).
std::vector<Operation> transformOperations();

}  // namespace handwheel
