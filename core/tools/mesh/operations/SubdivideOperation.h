// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "mesh/sculpt/SchemeSubdivision.h"

namespace handwheel {

// Returns the description of the subdivision of a whole mesh.
const Operation& subdivideMeshOperation();

SchemeSubdivision schemeSubdivisionOf(const OperationValues& values);
OperationValues valuesOf(const SchemeSubdivision& subdivision);

}  // namespace handwheel
