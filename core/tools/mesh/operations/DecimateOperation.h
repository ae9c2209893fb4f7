// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "mesh/simplify/Decimation.h"

namespace handwheel {

// Returns the description of the reduction of the number of triangles.
const Operation& decimateOperation();

DecimationOptions decimationOptionsOf(const OperationValues& values);
OperationValues valuesOf(const DecimationOptions& options);

// Returns the problem of values that name neither goal, or a goal that their method cannot keep, as a clause; otherwise
// empty.
std::string problemOf(const OperationValues& values);

}  // namespace handwheel
