// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/exercise/TurningTask.h"
#include "exercise/Exercise.h"

namespace handwheel {

// Returns the sizes of a target as criteria of a marking scheme, along its outline.
//
// They are diameters, tapers, arcs, and the lengths from the finished face to the other faces, except inside the chuck
// and sizes that the bar already has. A curve of many short lines (withCurves()) has a criterion of its form, the
// distance from the target, after all sizes, instead of its tapers. The limits are those of general tolerances (ISO
// 2768-1, class m); each gives a point. The ids are empty.
std::vector<MarkingCriterion> sizesOfTarget(const TurningTask& task);

}  // namespace handwheel
