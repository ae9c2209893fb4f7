// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/ExerciseSnapshot.h"

#include <QtGlobal>
#include <algorithm>
#include <array>
#include <cassert>

namespace handwheel {

namespace {

constexpr const char *kTime = "time", *kHints = "hints";

std::optional<double> commonValue(std::string_view figure, const Attempt& attempt) {
  if (figure == kTime) return attempt.seconds;
  if (figure == kHints) return static_cast<double>(attempt.hintCount());
  return std::nullopt;
}

}  // namespace

std::span<const MeasurementType> commonMeasurements() {
  static const std::array<MeasurementType, 2> kCommon = {
      {{kTime, QT_TRANSLATE_NOOP("Figure", "Time of the work"), "s"},
       {kHints, QT_TRANSLATE_NOOP("Figure", "Hints looked at"), ""}}};
  return kCommon;
}

ExerciseSnapshot forStudents(ExerciseSnapshot exercise) {
  exercise.exercise = withoutAnswers(std::move(exercise.exercise));
  assert(hasNoAnswers(exercise.exercise));
  exercise.solution.reset();
  exercise.work.reset();
  exercise.attempt.reset();
  exercise.marked.reset();
  exercise.others.reset();
  exercise.describedSolution.reset();
  exercise.madeOfDescription.reset();
  exercise.isForStudents = true;
  return exercise;
}

const MeasurementType* measurementType(std::span<const MeasurementType> types, std::string_view id) {
  const auto found =
      std::find_if(types.begin(), types.end(), [&](const MeasurementType& type) { return type.id == id; });
  return found == types.end() ? nullptr : &*found;
}

std::vector<MeasurementType> measurementTypes(const ExerciseSubject& subject) {
  std::vector<MeasurementType> all = subject.figures();
  all.insert(all.end(), commonMeasurements().begin(), commonMeasurements().end());
  return all;
}

Marking markWork(const ExerciseSnapshot& scheme, const Snapshot& work, const Attempt& attempt, Progress progress) {
  std::vector<Measurement> figures = scheme.subject->measure(scheme.exercise, *scheme.task, work, progress);
  const std::vector<MeasurementType> types = measurementTypes(*scheme.subject);
  std::vector<std::string> units;
  for (const MarkingCriterion& c : scheme.exercise.criteria) {
    if (const auto value = commonValue(c.figure, attempt)) figures.push_back({c.id, value, {}});
    const MeasurementType* type = measurementType(types, c.figure);
    units.push_back(type ? type->unit : std::string());
  }
  return markMeasurements(scheme.exercise, figures, units);
}

}  // namespace handwheel
