// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// Whether the words ask for many files: several operands, a folder, or an option that only many have.
bool isBatch(const Arguments& arguments);

// 'handwheel repair' of many files. Exit codes: done: all are closed; something left: and none failed; error: one
// failed, or nothing could be begun.
int runBatchRepair(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
