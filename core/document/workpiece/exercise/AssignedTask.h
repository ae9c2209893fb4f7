// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/AssignedExercise.h"
#include "document/workpiece/exercise/TurningTask.h"

#include <string_view>

namespace handwheel {

// The limits of a lathe for work on an exercise. Beyond them a mark is lost, or the report says so. 0: no limit.
struct WorkLimits {
  double force = 0.0;  // N
  double power = 0.0;  // kW
  double feed = 0.0;   // mm per revolution; not of threads
  bool operator==(const WorkLimits&) const = default;
};

// Returns the smaller limits of the lathe of an exercise and of its marks, as far as the student's copy has them. There
// are none without an exercise of turning.
WorkLimits workLimits(const AssignedExercise& assigned);

// Returns the task of the exercise that a workpiece is work on. Returns null if the workpiece is not work on an
// exercise of turning.
std::shared_ptr<const TurningTask> assignedTask(const AssignedExercise& assigned);

// Returns true if the marking scheme, as the student sees it, has a criterion for a figure, such as "force".
bool isMarked(const AssignedExercise& assigned, std::string_view figure);

}  // namespace handwheel
