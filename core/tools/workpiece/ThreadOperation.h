// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Operation.h"
#include "document/workpiece/WorkpieceSnapshot.h"

namespace handwheel {

// Returns the operation "thread", which cuts a thread into a workpiece. The thread lies between two positions along Z,
// in the coordinates of the document.
const Operation& threadOperation();

// Returns the pass that cuts the thread. The default depth is that of the ISO metric profile, measured from the present
// surface. The surface is at the largest radius of the range outside, and at the least radius in a bore. Errors:
// ElementMalformed {"thread", what is wrong}.
Result<TurningPass> threadPass(const WorkpieceSnapshot& workpiece, const OperationValues& values);

}  // namespace handwheel
