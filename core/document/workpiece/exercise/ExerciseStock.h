// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceSnapshot.h"
#include "document/workpiece/exercise/TurningTask.h"

namespace handwheel {

// The initial workpiece of a student in an exercise of turning.
struct ExerciseStock {
  WorkpieceSnapshot bar;
  std::shared_ptr<const TurningTask> task;  // the task, with its target if there is one
};

// Returns the largest deviation of a part from the target of the task, mm. Only the range above the chuck and above the
// lower end of the target counts. The task must have a target.
double targetError(const ExerciseStock& exercise, const TurnedProfile& part);

// Returns the stock of an exercise document's value; nothing for other documents and for exercises about other work.
std::optional<ExerciseStock> exerciseStock(const Snapshot& content);

// Returns the workpiece in the value of a document, which is a workpiece document or an exercise with work. Returns
// null if there is no workpiece.
std::shared_ptr<const WorkpieceSnapshot> turnedWorkIn(const SnapshotPointer& content);

}  // namespace handwheel
