// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/exercise/TurningTask.h"
#include "exercise/Exercise.h"

namespace handwheel {

// Returns the sizes of a target as criteria of a marking scheme, along its outline.
//
// The sizes are diameters, tapers, arcs, and the lengths from the finished face to the other faces. Sizes inside the
// chuck and sizes that the bar already has are left out. A curve of many short lines (withCurves()) has, instead of its
// tapers, a criterion for its distance from the target; this follows after all sizes. The limits are general tolerances
// (ISO 2768-1, class m). Each criterion gives one point, and its id is empty.
std::vector<MarkingCriterion> sizesOfTarget(const TurningTask& task);

}  // namespace handwheel
