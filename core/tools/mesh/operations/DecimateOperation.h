// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "mesh/simplify/Decimation.h"

namespace handwheel {

// The description of the reduction of the number of triangles.
const Operation& decimateOperation();

DecimationOptions decimationOptionsOf(const OperationValues& values);
OperationValues valuesOf(const DecimationOptions& options);

// What is wrong with values that say neither of the goals, or what their method cannot keep, as a clause; nothing for
// others.
std::string problemOf(const OperationValues& values);

}  // namespace handwheel
