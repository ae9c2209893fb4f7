// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/exercise/TurningTask.h"
#include "exercise/Exercise.h"
#include "machining/drawing/PartDrawing.h"

#include <string>
#include <vector>

namespace handwheel {

// Returns the threads that the visible criteria ask for, for the drawing. Criteria of threads
// along overlapping ranges ask for one thread. Its size and pitch come from the designation of a tolerance, else from
// the criteria, else from the target. A thread whose size or pitch is in none of them is left out, and so is one along
// a bored target whose criteria do not name its size, since it may be outside or inside.
std::vector<DrawnThread> threadsAskedFor(const Exercise& exercise, const TurningTask& task);

// Returns the reason why the limits of a criterion contradict the class of a thread along the same range, as an English
// text that is translated in the context "Property". The text is empty if they do not. A diameter, or a diameter of the
// thread, contradicts it if its limits admit a size that the class refuses.
std::string threadConflict(const MarkingCriterion& criterion, const Exercise& exercise);

}  // namespace handwheel
