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

// Returns the problem of the values as a clause. There is a problem if they specify no goal, or a goal that their
// method cannot meet; otherwise the text is empty.
std::string problemOf(const OperationValues& values);

}  // namespace handwheel
