// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/workpiece/TurnRequest.h"
#include "cli/workpiece/TurnStatistics.h"

namespace handwheel {

// Returns the workpiece after the program of the request, in the chuck of its lathe. remarks: receives notes and
// collisions, with their lines. Errors: those of the files, of runProgram(), Cancelled.
Result<WorkpieceSnapshot> turnByProgram(WorkpieceSnapshot workpiece, const TurnRequest& request,
                                        TurnStatistics& figures, std::vector<std::string>& remarks, Progress progress);

}  // namespace handwheel
