// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceSnapshot.h"
#include "document/workpiece/exercise/TurningTask.h"

namespace handwheel {

// The initial workpiece of a student in an exercise of turning.
struct ExerciseStock {
  WorkpieceSnapshot bar;
  std::shared_ptr<const TurningTask> task;  // with the target, if there is one
};

// Returns the largest deviation of a part from the target of the task, mm: above the chuck, and above the bar behind
// the target. The task must have a target.
double targetError(const ExerciseStock& exercise, const TurnedProfile& part);

// Returns the stock of an exercise document's value; none for other documents, and exercises about other work.
std::optional<ExerciseStock> exerciseStock(const Snapshot& content);

// Returns the workpiece that a document is, or that is the work on its exercise; null: there is none.
std::shared_ptr<const WorkpieceSnapshot> turnedWorkIn(const SnapshotPointer& content);

}  // namespace handwheel
