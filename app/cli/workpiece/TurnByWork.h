// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/workpiece/TurnRequest.h"
#include "cli/workpiece/TurnStatistics.h"

namespace handwheel {

// Cuts the recorded passes of another workpiece in this one. The other workpiece was turned, ground, bored or threaded
// by hand in the window. On the same bar, the result is the same part bit for bit. Recorded crashes are copied. Error:
// Cancelled.
Result<WorkpieceSnapshot> turnByWork(WorkpieceSnapshot workpiece, const WorkpieceSnapshot& work,
                                     const TurnRequest& request, TurnStatistics& figures, Progress progress);

}  // namespace handwheel
