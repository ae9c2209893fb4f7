// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Operation.h"
#include "document/workpiece/WorkpieceSnapshot.h"

namespace handwheel {

// The operation "thread": cuts a thread into a workpiece, between two heights of the document.
const Operation& threadOperation();

// Returns the pass that cuts the thread. The default depth is that of the ISO metric profile, from the present surface:
// the largest radius of the range outside, the least in a bore. Errors: ElementMalformed {"thread", what is wrong}.
Result<TurningPass> threadPass(const WorkpieceSnapshot& workpiece, const OperationValues& values);

}  // namespace handwheel
