// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/ExerciseJson.h"

#include "base/JsonText.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using Json = nlohmann::json;

Json jsonOf(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

std::optional<double> numberAt(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  if (found == object.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

bool flagAt(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() && found->is_boolean() && found->get<bool>();
}

// The elements of an array under a key; none where there is no array.
const Json& arrayAt(const Json& object, const char* key) {
  static const Json kNone = Json::array();
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() && found->is_array() ? *found : kNone;
}

std::vector<std::string> textsAt(const Json& object, const char* key, std::size_t most) {
  std::vector<std::string> texts;
  for (const Json& each : arrayAt(object, key)) {
    if (each.is_string() && texts.size() < most) texts.push_back(each.get<std::string>());
  }
  return texts;
}

Json jsonOf(const MarkingCriterion& c) {
  return {{"id", c.id},
          {"name", c.name},
          {"figure", c.figure},
          {"arguments", c.arguments},
          {"nominal", jsonOf(c.nominal)},
          {"tolerance", c.tolerance},
          {"lower", jsonOf(c.lower)},
          {"upper", jsonOf(c.upper)},
          {"points", c.points},
          {"slack", c.slack},
          {"hidden", c.isHidden}};
}

MarkingCriterion criterionFrom(const Json& json) {
  MarkingCriterion c;
  c.id = stringAt(json, "id");
  c.name = stringAt(json, "name");
  c.figure = stringAt(json, "figure");
  c.arguments = numbersAt(json, "arguments", Exercise::kMostArguments);
  c.nominal = numberAt(json, "nominal");
  c.tolerance = stringAt(json, "tolerance");
  c.lower = numberAt(json, "lower");
  c.upper = numberAt(json, "upper");
  c.points = numberAt(json, "points").value_or(0.0);
  c.slack = numberAt(json, "slack").value_or(0.0);
  c.isHidden = flagAt(json, "hidden");
  return c;
}

ExerciseStep stepFrom(const Json& json) {
  return {stringAt(json, "title"), stringAt(json, "text"), textsAt(json, "hints", Exercise::kMostHints),
          textsAt(json, "criteria", Exercise::kMostCriteria)};
}

// Keeps the last row of an exercise, or takes it out and says why.
template <class Row>
void keepIfSound(Exercise& exercise, std::vector<Row>& rows, std::vector<Error>& damage) {
  const Status checked = checkExercise(exercise);
  if (checked) return;
  damage.push_back(checked.error());
  rows.pop_back();
}

}  // namespace

Json toJson(const Exercise& exercise) {
  Json steps = Json::array(), criteria = Json::array();
  for (const ExerciseStep& step : exercise.steps)
    steps.push_back({{"title", step.title}, {"text", step.text}, {"hints", step.hints}, {"criteria", step.criteria}});
  for (const MarkingCriterion& c : exercise.criteria) criteria.push_back(jsonOf(c));
  return {{"title", exercise.title},   {"author", exercise.author},
          {"text", exercise.text},     {"allowed_seconds", exercise.allowedSeconds},
          {"steps", std::move(steps)}, {"criteria", std::move(criteria)}};
}

Exercise exerciseFrom(const Json& json, std::vector<Error>& damage) {
  Exercise exercise;
  exercise.title = stringAt(json, "title");
  exercise.author = stringAt(json, "author");
  exercise.text = stringAt(json, "text");
  exercise.allowedSeconds = numberAt(json, "allowed_seconds").value_or(0.0);
  if (const Status checked = checkExercise(exercise); !checked) {
    damage.push_back(checked.error());
    exercise = Exercise();
  }
  const auto tooMany = [&](const char* what, std::size_t count, std::size_t most) {
    damage.push_back({ErrorCode::FileTooLarge, {what, std::to_string(count), std::to_string(most)}, {}, {}});
  };
  const Json &criteria = arrayAt(json, "criteria"), &steps = arrayAt(json, "steps");
  for (const Json& each : criteria) {
    if (exercise.criteria.size() == Exercise::kMostCriteria) {
      tooMany("criteria", criteria.size(), Exercise::kMostCriteria);
      break;
    }
    exercise.criteria.push_back(criterionFrom(each));
    keepIfSound(exercise, exercise.criteria, damage);
  }
  for (const Json& each : steps) {
    if (exercise.steps.size() == Exercise::kMostSteps) {
      tooMany("steps", steps.size(), Exercise::kMostSteps);
      break;
    }
    exercise.steps.push_back(stepFrom(each));
    keepIfSound(exercise, exercise.steps, damage);
  }
  return exercise;
}

Json toJson(const Attempt& attempt) {
  return {{"student", attempt.student}, {"begun", attempt.begun}, {"handed_in", attempt.handedIn},
          {"seconds", attempt.seconds}, {"hints", attempt.hints}, {"done", attempt.done}};
}

Attempt attemptFrom(const Json& json, std::vector<Error>& damage) {
  Attempt attempt;
  for (const auto& [key, text] : {std::pair{"student", &attempt.student}, std::pair{"begun", &attempt.begun},
                                  std::pair{"handed_in", &attempt.handedIn}}) {
    *text = stringAt(json, key);
    if (text->size() <= Attempt::kLongestText) continue;
    text->clear();
    damage.push_back({ErrorCode::ElementMalformed, {key, "it is too long"}, {}, {}});
  }
  const double seconds = numberAt(json, "seconds").value_or(0.0);
  if (seconds >= 0.0 && seconds <= Exercise::kLongestTime) {
    attempt.seconds = seconds;
  } else {
    damage.push_back({ErrorCode::ElementMalformed, {"attempt", "its time is impossible"}, {}, {}});
  }
  for (const Json& each : arrayAt(json, "hints")) {
    if (attempt.hints.size() == Exercise::kMostSteps) break;
    const auto count = each.is_number_unsigned() ? each.get<std::uint64_t>() : 0;
    attempt.hints.push_back(static_cast<std::size_t>(std::min<std::uint64_t>(count, Exercise::kMostHints)));
  }
  for (const Json& each : arrayAt(json, "done")) {
    if (attempt.done.size() < Exercise::kMostSteps) attempt.done.push_back(each.is_boolean() && each.get<bool>());
  }
  return attempt;
}

}  // namespace handwheel
