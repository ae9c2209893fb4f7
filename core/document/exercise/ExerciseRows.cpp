// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/ExerciseRows.h"

#include <algorithm>

namespace handwheel {

namespace {

template <class Row>
void moveRow(std::vector<Row>& rows, std::size_t row, bool isUp) {
  const std::size_t other = isUp ? row - 1 : row + 1;  // of the first one up: beyond the end
  if (row < rows.size() && other < rows.size()) std::swap(rows[row], rows[other]);
}

}  // namespace

ExerciseSnapshot withNewCriterion(ExerciseSnapshot exercise, const FigureType& figure) {
  MarkingCriterion c;
  for (int number = 1; c.id.empty() || exercise.exercise.find(c.id); ++number) c.id = "c" + std::to_string(number);
  c.name = figure.label;
  c.figure = figure.id;
  c.arguments.assign(figure.arguments.size(), 0.0);
  c.points = 1.0;
  c.upper = exercise.subject->usualLimit(figure.id, *exercise.task);
  if (exercise.exercise.criteria.size() < Exercise::kMostCriteria) exercise.exercise.criteria.push_back(std::move(c));
  return exercise;
}

ExerciseSnapshot withNewStep(ExerciseSnapshot exercise) {
  if (exercise.exercise.steps.size() < Exercise::kMostSteps) exercise.exercise.steps.emplace_back();
  return exercise;
}

ExerciseSnapshot withoutCriterion(ExerciseSnapshot exercise, const std::string& id) {
  std::erase_if(exercise.exercise.criteria, [&](const MarkingCriterion& c) { return c.id == id; });
  for (ExerciseStep& step : exercise.exercise.steps) std::erase(step.criteria, id);
  return exercise;
}

ExerciseSnapshot withMovedCriterion(ExerciseSnapshot exercise, std::size_t row, bool isUp) {
  moveRow(exercise.exercise.criteria, row, isUp);
  return exercise;
}

ExerciseSnapshot withMovedStep(ExerciseSnapshot exercise, std::size_t row, bool isUp) {
  moveRow(exercise.exercise.steps, row, isUp);
  return exercise;
}

ExerciseSnapshot withoutStep(ExerciseSnapshot exercise, std::size_t step) {
  auto& steps = exercise.exercise.steps;
  if (step < steps.size()) steps.erase(steps.begin() + static_cast<std::ptrdiff_t>(step));
  return exercise;
}

}  // namespace handwheel
