// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/ExerciseStock.h"

#include "document/exercise/ExerciseSnapshot.h"
#include "machining/target/TargetDeviation.h"

namespace handwheel {

double targetError(const ExerciseStock& exercise, const TurnedProfile& part) {
  const TurningTask& task = *exercise.task;
  const AxisRange range = rangeOfTarget(*task.target, part, 0.0, task.lathe.chuckHeight);
  return deviationFrom(*task.target, part, 0.0, {}, range).largest();
}

std::shared_ptr<const WorkpieceSnapshot> turnedWorkIn(const SnapshotPointer& content) {
  if (auto workpiece = std::dynamic_pointer_cast<const WorkpieceSnapshot>(content)) return workpiece;
  const auto exercise = std::dynamic_pointer_cast<const ExerciseSnapshot>(content);
  return exercise ? std::dynamic_pointer_cast<const WorkpieceSnapshot>(exercise->work) : nullptr;
}

std::optional<ExerciseStock> exerciseStock(const Snapshot& content) {
  const auto* exercise = dynamic_cast<const ExerciseSnapshot*>(&content);
  auto task = exercise ? std::dynamic_pointer_cast<const TurningTask>(exercise->task) : nullptr;
  if (!task) return std::nullopt;
  const SnapshotPointer bar = exercise->subject->start(*task);
  return ExerciseStock{static_cast<const WorkpieceSnapshot&>(*bar), std::move(task)};
}

}  // namespace handwheel
