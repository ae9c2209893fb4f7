// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// Returns true if the arguments ask for a batch repair. That is: several operands, a folder, or an option that only
// batches have.
bool isBatch(const Arguments& arguments);

// Runs 'handwheel repair' on many files. Exit codes: kExitDone: all are closed; kExitSomethingLeft: some are not, but
// none failed; kExitError: one failed, or the batch could not be started.
int runBatchRepair(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
