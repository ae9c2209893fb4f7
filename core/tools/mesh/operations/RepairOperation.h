// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "mesh/repair/Repair.h"

namespace handwheel {

// Returns the description of the repair of a whole mesh.
const Operation& repairOperation();

// Convert the options of a repair from and to values. The loops that stay open are not among the values, but belong to
// the document.
RepairOptions repairOptionsOf(const OperationValues& values);
OperationValues valuesOf(const RepairOptions& options);

}  // namespace handwheel
