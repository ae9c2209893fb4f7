// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/workpiece/TurnRequest.h"
#include "cli/workpiece/TurnStatistics.h"

namespace handwheel {

// Runs the program of a request on the lathe of a workpiece. Returns the workpiece with the cuts. remarks: receives
// notes and collisions with their lines in the program. Errors: the errors of reading the files and of runProgram(),
// Cancelled.
Result<WorkpieceSnapshot> turnByProgram(WorkpieceSnapshot workpiece, const TurnRequest& request,
                                        TurnStatistics& figures, std::vector<std::string>& remarks, Progress progress);

}  // namespace handwheel
