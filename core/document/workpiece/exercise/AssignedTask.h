// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/AssignedExercise.h"
#include "document/workpiece/exercise/TurningTask.h"

#include <string_view>

namespace handwheel {

// The task of the exercise that a workpiece is work on. Null: it is none, or of other work.
std::shared_ptr<const TurningTask> assignedTask(const AssignedExercise& assigned);

// Whether the marking scheme has a criterion for a figure, such as "force", as far as the student sees it.
bool isMarked(const AssignedExercise& assigned, std::string_view figure);

}  // namespace handwheel
