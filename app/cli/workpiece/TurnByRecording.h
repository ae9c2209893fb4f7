// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/workpiece/TurnRequest.h"
#include "cli/workpiece/TurnStatistics.h"

namespace handwheel {

// The workpiece after the recording of the request is replayed on it. Its forces are those at one speed of the spindle.
// unreadable: a sentence about the file, which is not cut as the arguments of an Error are; empty where it was read.
// Errors: those of the file, Cancelled.
Result<WorkpieceSnapshot> turnByRecording(const WorkpieceSnapshot& workpiece, const TurnRequest& request,
                                          TurnStatistics& figures, std::string& unreadable, Progress progress);

}  // namespace handwheel
