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

// How far a part is from the target of the task at most, mm: above the chuck, and above the bar behind the target. The
// task must have one.
double targetError(const ExerciseStock& exercise, const TurnedProfile& part);

// The stock of an exercise document's value; none for other documents, and exercises about other work.
std::optional<ExerciseStock> exerciseStock(const Snapshot& content);

// The workpiece that a document is, or that is the work on its exercise; null: there is none.
std::shared_ptr<const WorkpieceSnapshot> turnedWorkIn(const SnapshotPointer& content);

}  // namespace handwheel
