// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/exercise/TurningTask.h"
#include "exercise/Exercise.h"

namespace handwheel {

// The sizes of a target as criteria of a marking scheme, along its outline.
//
// Diameters, tapers, arcs, and the lengths from the finished face to the others; without what stays in the chuck, and
// what the bar has already. Of a curve of many short lines (withCurves()) its form, which is how far it is from the
// target, after all sizes, instead of its tapers. The limits are those of general tolerances (ISO 2768-1, class m);
// each gives a point. The ids are empty.
std::vector<MarkingCriterion> sizesOfTarget(const TurningTask& task);

}  // namespace handwheel
