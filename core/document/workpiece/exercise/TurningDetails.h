// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceSnapshot.h"
#include "document/workpiece/exercise/TurningTask.h"

namespace handwheel {

// Returns the details of turning work for a report. The details are a picture of the part over its target, the largest
// force and power, the shape, the path of the tool, roughness, force and power over time, collisions and overloads.
// O(samples + points of the passes).
ReportDetails turningDetails(const TurningTask& task, const WorkpieceSnapshot& work, Progress progress);

}  // namespace handwheel
