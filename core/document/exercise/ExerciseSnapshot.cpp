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

std::span<const FigureType> commonFigures() {
  static const std::array<FigureType, 2> kCommon = {{{kTime, QT_TRANSLATE_NOOP("Figure", "Time of the work"), "s"},
                                                     {kHints, QT_TRANSLATE_NOOP("Figure", "Hints looked at"), ""}}};
  return kCommon;
}

ExerciseSnapshot forStudents(ExerciseSnapshot exercise) {
  exercise.exercise = withoutAnswers(std::move(exercise.exercise));
  assert(hasNoAnswers(exercise.exercise));
  exercise.solution.reset();
  exercise.work.reset();
  exercise.attempt.reset();
  exercise.others.reset();
  exercise.describedSolution.reset();
  exercise.madeOfDescription.reset();
  exercise.isForStudents = true;
  return exercise;
}

const FigureType* figureType(std::span<const FigureType> types, std::string_view id) {
  const auto found = std::find_if(types.begin(), types.end(), [&](const FigureType& type) { return type.id == id; });
  return found == types.end() ? nullptr : &*found;
}

std::vector<FigureType> figureTypes(const ExerciseSubject& subject) {
  std::vector<FigureType> all = subject.figures();
  all.insert(all.end(), commonFigures().begin(), commonFigures().end());
  return all;
}

Marking markWork(const ExerciseSnapshot& scheme, const Snapshot& work, const Attempt& attempt, Progress progress) {
  std::vector<Figure> figures = scheme.subject->measure(scheme.exercise, *scheme.task, work, progress);
  const std::vector<FigureType> types = figureTypes(*scheme.subject);
  std::vector<std::string> units;
  for (const MarkingCriterion& c : scheme.exercise.criteria) {
    if (const auto value = commonValue(c.figure, attempt)) figures.push_back({c.id, value, {}});
    const FigureType* type = figureType(types, c.figure);
    units.push_back(type ? type->unit : std::string());
  }
  return markFigures(scheme.exercise, figures, units);
}

}  // namespace handwheel
