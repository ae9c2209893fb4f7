// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/ExerciseRows.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

template <class Row>
void moveRow(std::vector<Row>& rows, std::size_t row, bool isUp) {
  const std::size_t other = isUp ? row - 1 : row + 1;  // for row 0 moved up it is out of range
  if (row < rows.size() && other < rows.size()) std::swap(rows[row], rows[other]);
}

// Compares the nominal value, or else the limits: a target may lie in the middle of a tolerance zone.
bool isMarkedBy(const MarkingCriterion& size, const MarkingCriterion& c) {
  constexpr double kSame = 1e-3;
  if (!size.nominal || c.figure != size.figure || c.arguments.size() != size.arguments.size()) return false;
  const bool isNominal = c.nominal && std::abs(*c.nominal - *size.nominal) <= kSame;
  return isNominal || (c.lower && c.upper && *c.lower <= *size.nominal && *size.nominal <= *c.upper);
}

// A size without a nominal value is a deviation along a range: it is marked if a criterion covers most of the range.
bool isRangeMarkedBy(const MarkingCriterion& size, const MarkingCriterion& c) {
  if (size.nominal || c.figure != size.figure || size.arguments.size() != 2 || c.arguments.size() != 2) return false;
  const double from = std::max(size.arguments[0], c.arguments[0]), to = std::min(size.arguments[1], c.arguments[1]);
  return to - from > 0.5 * (size.arguments[1] - size.arguments[0]);
}

// Returns the distance between the positions of two criteria of one figure.
double distance(const MarkingCriterion& a, const MarkingCriterion& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.arguments.size(); ++i) sum += std::abs(a.arguments[i] - b.arguments[i]);
  return sum;
}

}  // namespace

ExerciseSnapshot withNewCriterion(ExerciseSnapshot exercise, const MeasurementType& figure) {
  MarkingCriterion c;
  c.name = figure.label;
  c.figure = figure.id;
  c.arguments.assign(figure.arguments.size(), 0.0);
  c.points = 1.0;
  c.upper = exercise.subject->usualLimit(figure.id, *exercise.task);
  return withCriteria(std::move(exercise), {std::move(c)});
}

ExerciseSnapshot withCriteria(ExerciseSnapshot exercise, std::vector<MarkingCriterion> criteria) {
  int number = 1;
  for (MarkingCriterion& c : criteria) {
    if (exercise.exercise.criteria.size() >= Exercise::kMostCriteria) break;
    while (exercise.exercise.find("c" + std::to_string(number))) ++number;
    c.id = "c" + std::to_string(number);
    exercise.exercise.criteria.push_back(std::move(c));
  }
  return exercise;
}

std::vector<MarkingCriterion> unmarkedSizes(const ExerciseSnapshot& exercise) {
  std::vector<MarkingCriterion> sizes = exercise.subject->targetSizes(*exercise.task);
  for (const MarkingCriterion& marked : exercise.exercise.criteria) {
    std::erase_if(sizes, [&](const MarkingCriterion& size) { return isRangeMarkedBy(size, marked); });
    auto nearest = sizes.end();
    for (auto size = sizes.begin(); size != sizes.end(); ++size) {
      if (!isMarkedBy(*size, marked)) continue;
      if (nearest == sizes.end() || distance(*size, marked) < distance(*nearest, marked)) nearest = size;
    }
    if (nearest != sizes.end()) sizes.erase(nearest);
  }
  return sizes;
}

std::optional<Note> offTargetNote(const ExerciseSnapshot& exercise) {
  const std::vector<std::string> off = exercise.subject->criteriaOffTarget(exercise.exercise, *exercise.task);
  if (off.empty()) return std::nullopt;
  std::string names;
  for (const std::string& id : off) names += (names.empty() ? "“" : ", “") + exercise.exercise.find(id)->name + "”";
  return Note{QT_TRANSLATE_NOOP("Note",
                                "These marks do not fit the target, which itself would not meet them: %1. Change or "
                                "delete them."),
              {names}};
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
