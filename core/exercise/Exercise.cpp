// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "exercise/Exercise.h"

#include "base/NumberText.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace handwheel {

namespace {

Error malformed(const std::string& where, const char* what) {
  return {ErrorCode::ElementMalformed, {where, what}, {}, {}};
}

bool isWithin(double value, double largest) {
  return value >= 0.0 && value <= largest;  // not NaN
}

bool isFigure(const std::optional<double>& value) {
  return !value || std::abs(*value) <= Exercise::kLargestFigure;
}

bool isIdSign(char c) {
  return isLetter(c) || isDigit(c) || c == '_' || c == '-';
}

bool isLong(const std::string& text) {
  return text.size() > Exercise::kLongestText;
}

const char* problemOf(const MarkingCriterion& c) {
  if (c.id.empty() || c.id.size() > 100) return "its id is empty or too long";
  if (!std::all_of(c.id.begin(), c.id.end(), isIdSign)) return "its id has other signs than letters, digits, _ and -";
  if (isLong(c.name) || isLong(c.tolerance) || isLong(c.figure)) return "a text is too long";
  if (c.arguments.size() > Exercise::kMostArguments) return "it has too many arguments";
  for (const double argument : c.arguments) {
    if (!isFigure(argument)) return "an argument is impossible";
  }
  if (!isFigure(c.nominal) || !isFigure(c.lower) || !isFigure(c.upper)) return "a limit is impossible";
  if (c.lower && c.upper && *c.lower > *c.upper) return "its lower limit is above the upper one";
  if (!isWithin(c.points, Exercise::kMostPoints)) return "its points are impossible";
  if (!isWithin(c.slack, Exercise::kLargestFigure)) return "its slack is impossible";
  return nullptr;
}

const char* problemOf(const ExerciseStep& step) {
  if (isLong(step.title) || isLong(step.text)) return "a text is too long";
  if (step.hints.size() > Exercise::kMostHints) return "it has too many hints";
  if (step.criteria.size() > Exercise::kMostCriteria) return "it names too many criteria";
  return std::any_of(step.hints.begin(), step.hints.end(), isLong) ? "a hint is too long" : nullptr;
}

}  // namespace

double Exercise::points() const {
  double sum = 0.0;
  for (const MarkingCriterion& c : criteria) sum += c.points;
  return sum;
}

const MarkingCriterion* Exercise::find(std::string_view id) const {
  const auto found =
      std::find_if(criteria.begin(), criteria.end(), [&](const MarkingCriterion& c) { return c.id == id; });
  return found == criteria.end() ? nullptr : &*found;
}

std::string namedInErrors(const MarkingCriterion& criterion) {
  if (criterion.name.empty()) return "criterion " + criterion.id;
  return "criterion “" + criterion.name + "” (" + criterion.id + ")";
}

Status checkExercise(const Exercise& exercise) {
  if (isLong(exercise.title) || isLong(exercise.author) || isLong(exercise.text))
    return malformed("exercise", "a text is too long");
  if (!isWithin(exercise.allowedSeconds, Exercise::kLongestTime)) return malformed("time", "it is impossible");
  if (exercise.criteria.size() > Exercise::kMostCriteria) return malformed("criteria", "there are too many");
  if (exercise.steps.size() > Exercise::kMostSteps) return malformed("steps", "there are too many");
  std::set<std::string_view> ids;
  for (const MarkingCriterion& c : exercise.criteria) {
    if (const char* problem = problemOf(c)) return malformed(namedInErrors(c), problem);
    if (!ids.insert(c.id).second) return malformed(namedInErrors(c), "there are two with this id");
  }
  for (std::size_t i = 0; i < exercise.steps.size(); ++i) {
    const std::string where = "step " + std::to_string(i + 1);
    if (const char* problem = problemOf(exercise.steps[i])) return malformed(where, problem);
    for (const std::string& id : exercise.steps[i].criteria) {
      if (!ids.contains(id)) return malformed(where, "it refers to a criterion that does not exist");
    }
  }
  return Done{};
}

Exercise withoutAnswers(Exercise exercise) {
  std::erase_if(exercise.criteria, [](const MarkingCriterion& c) { return c.isHidden; });
  for (MarkingCriterion& c : exercise.criteria) {
    c.points = c.slack = 0.0;
    c.others.clear();
  }
  for (ExerciseStep& step : exercise.steps) {
    step.others.clear();
    std::erase_if(step.criteria, [&](const std::string& id) { return !exercise.find(id); });
  }
  return exercise;
}

bool hasNoAnswers(const Exercise& exercise) {
  return std::none_of(exercise.criteria.begin(), exercise.criteria.end(),
                      [](const MarkingCriterion& c) { return c.isHidden || c.points > 0.0 || c.slack > 0.0; });
}

}  // namespace handwheel
