// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/workpiece/TurnRequest.h"
#include "cli/workpiece/TurnStatistics.h"

namespace handwheel {

// Returns the workpiece after the recording of the request is replayed on it. Forces are calculated at one spindle
// speed. unreadable: receives a sentence about a file that cannot be read, or an empty string; unlike the arguments of
// an Error, the sentence is not shortened. Errors: the errors of reading the file, Cancelled.
Result<WorkpieceSnapshot> turnByRecording(const WorkpieceSnapshot& workpiece, const TurnRequest& request,
                                          TurnStatistics& figures, std::string& unreadable, Progress progress);

}  // namespace handwheel
