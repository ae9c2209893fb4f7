// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/workpiece/TurnRequest.h"
#include "cli/workpiece/TurnStatistics.h"

namespace handwheel {

// Returns the workpiece after the recording of the request is replayed on it. Forces are those at one spindle speed.
// unreadable: a sentence about the file, which is not shortened as arguments of an Error are; empty if it was read.
// Errors: those of the file, Cancelled.
Result<WorkpieceSnapshot> turnByRecording(const WorkpieceSnapshot& workpiece, const TurnRequest& request,
                                          TurnStatistics& figures, std::string& unreadable, Progress progress);

}  // namespace handwheel
