// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "cli/mesh/RepairJob.h"
#include "document/DocumentKind.h"

namespace handwheel {

// Returns the syntax of "handwheel repair", which fills holes and removes other defects of meshes.
CommandSpec repairSpec();
int runRepair(const Arguments& arguments, const DocumentKinds& kinds);

// Reports the reason why a repair wrote no output. Returns the exit code.
int reportNothingWritten(const RepairRun& run, const RepairRequest& request);

}  // namespace handwheel
