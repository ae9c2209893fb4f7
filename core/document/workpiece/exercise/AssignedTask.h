// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/AssignedExercise.h"
#include "document/workpiece/exercise/TurningTask.h"

#include <string_view>

namespace handwheel {

// Returns the task of the exercise that a workpiece is work on. Returns null if the workpiece is not work on an
// exercise of turning.
std::shared_ptr<const TurningTask> assignedTask(const AssignedExercise& assigned);

// Returns true if the marking scheme, as the student sees it, has a criterion for a figure, such as "force".
bool isMarked(const AssignedExercise& assigned, std::string_view figure);

}  // namespace handwheel
