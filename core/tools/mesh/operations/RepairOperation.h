// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "mesh/repair/Repair.h"

namespace handwheel {

// Returns the description of the repair of a whole mesh.
const Operation& repairOperation();

// Convert values to the options of a repair, and back. The values do not include the loops that stay open; these are
// stored in the document.
RepairOptions repairOptionsOf(const OperationValues& values);
OperationValues valuesOf(const RepairOptions& options);

}  // namespace handwheel
