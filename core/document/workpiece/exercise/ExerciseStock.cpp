// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/ExerciseStock.h"

#include "document/exercise/ExerciseSnapshot.h"
#include "machining/target/TargetDeviation.h"

namespace handwheel {

double targetError(const ExerciseStock& exercise, const TurnedProfile& part) {
  const TurningTask& task = *exercise.task;
  return deviationFrom(*task.target, part, 0.0, {}, {task.lathe.chuckHeight, task.stock.length}).largest();
}

std::optional<ExerciseStock> exerciseStock(const Snapshot& content) {
  const auto* exercise = dynamic_cast<const ExerciseSnapshot*>(&content);
  auto task = exercise ? std::dynamic_pointer_cast<const TurningTask>(exercise->task) : nullptr;
  if (!task) return std::nullopt;
  const SnapshotPointer bar = exercise->subject->start(*task);
  return ExerciseStock{static_cast<const WorkpieceSnapshot&>(*bar), std::move(task)};
}

}  // namespace handwheel
