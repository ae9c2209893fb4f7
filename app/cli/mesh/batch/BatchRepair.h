// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// Returns true if the arguments ask for a batch repair. This is the case if there are several operands, a folder, or an
// option that only batches have.
bool isBatch(const Arguments& arguments);

// Runs 'handwheel repair' on many files. Returns kExitDone if all meshes are closed, kExitSomethingLeft if some are not
// closed but no file failed, and kExitError if a file failed or the batch could not be started.
int runBatchRepair(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
