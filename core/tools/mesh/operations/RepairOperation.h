// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "mesh/repair/Repair.h"

namespace handwheel {

// The description of the repair of a whole mesh.
const Operation& repairOperation();

// The options of a repair. Which loops stay open is not among the values, but stands in the document.
RepairOptions repairOptionsOf(const OperationValues& values);
OperationValues valuesOf(const RepairOptions& options);

}  // namespace handwheel
