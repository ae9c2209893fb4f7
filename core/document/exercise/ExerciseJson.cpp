// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/ExerciseJson.h"

#include "base/JsonFields.h"
#include "base/JsonText.h"
#include "document/container/UnknownPart.h"

#include <algorithm>

namespace handwheel {

namespace {

using Json = nlohmann::json;

// The elements of an array under a key; none where there is no array.
const Json& arrayAt(const Json& object, const char* key) {
  static const Json kNone = Json::array();
  const Json& found = JsonFieldReader(object).member(key);
  return found.is_array() ? found : kNone;
}

// Readers and writers of the lists and nested values of exercises; lists are limited in length.
struct ExerciseFieldWriter : JsonFieldWriter {
  using JsonFieldWriter::JsonFieldWriter;
  using JsonFieldWriter::operator();
  void operator()(const char* key, const std::optional<double>& value) const {
    (*this)(key, value ? Json(*value) : Json());
  }
  void operator()(const char* key, const auto& list, std::size_t) const { (*this)(key, Json(list)); }
};

struct ExerciseFieldReader : JsonFieldReader {
  explicit ExerciseFieldReader(const Json& object) : JsonFieldReader(object), m_object(object) {}
  using JsonFieldReader::operator();
  void operator()(const char* key, std::optional<double>& value) const {
    if (const Json& found = member(key); found.is_number()) value = found.get<double>();
  }
  void operator()(const char* key, std::vector<double>& list, std::size_t most) const {
    list = numbersAt(m_object, key, most);
  }
  void operator()(const char* key, std::vector<std::string>& list, std::size_t most) const {
    for (const Json& each : arrayAt(m_object, key)) {
      if (each.is_string() && list.size() < most) list.push_back(each.get<std::string>());
    }
  }

 private:
  const Json& m_object;
};

// The keys, each once: for reader and writer, and for values that are const or not.
template <class Criterion>
void visitCriterion(Criterion& c, const auto& visit) {
  visit("id", c.id);
  visit("name", c.name);
  visit("figure", c.figure);
  visit("arguments", c.arguments, Exercise::kMostArguments);
  visit("nominal", c.nominal);
  visit("tolerance", c.tolerance);
  visit("lower", c.lower);
  visit("upper", c.upper);
  visit("points", c.points);
  visit("slack", c.slack);
  visit("hidden", c.isHidden);
  visit("decisive", c.isDecisive);
}

template <class Step>
void visitStep(Step& step, const auto& visit) {
  visit("title", step.title);
  visit("text", step.text);
  visit("hints", step.hints, Exercise::kMostHints);
  visit("criteria", step.criteria, Exercise::kMostCriteria);
}

// Handles the fields except for the rows.
template <class Head>
void visitHead(Head& exercise, const auto& visit) {
  visit("title", exercise.title);
  visit("author", exercise.author);
  visit("text", exercise.text);
  visit("allowed_seconds", exercise.allowedSeconds);
}

template <class Texts>
void visitAttemptTexts(Texts& attempt, const auto& visit) {
  visit("student", attempt.student);
  visit("begun", attempt.begun);
  visit("handed_in", attempt.handedIn);
}

constexpr const char *kSteps = "steps", *kCriteria = "criteria";                          // keys of an exercise
constexpr const char *kSeconds = "seconds", *kHintsSeen = "hints", *kStepsDone = "done";  // keys of an attempt

// Returns a row with its unknown keys.
Json withOthers(Json row, const std::string& others) {
  if (others.empty()) return row;
  return withUnknown(Json::parse(others, nullptr, false), std::move(row));
}

Json rowJson(const MarkingCriterion& c) {
  Json row = Json::object();
  visitCriterion(c, ExerciseFieldWriter(row));
  return row;
}

Json rowJson(const ExerciseStep& step) {
  Json row = Json::object();
  visitStep(step, ExerciseFieldWriter(row));
  return row;
}

template <class Row>
std::string othersOf(const Json& read, const Row& row) {
  const Json beyond = read.is_object() ? keysBeyond(read, rowJson(row)) : Json::object();
  return beyond.empty() ? std::string() : beyond.dump();
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
  Json json = Json::object(), steps = Json::array(), criteria = Json::array();
  visitHead(exercise, ExerciseFieldWriter(json));
  for (const ExerciseStep& step : exercise.steps) steps.push_back(withOthers(rowJson(step), step.others));
  for (const MarkingCriterion& c : exercise.criteria) criteria.push_back(withOthers(rowJson(c), c.others));
  json[kSteps] = std::move(steps);
  json[kCriteria] = std::move(criteria);
  return json;
}

Exercise exerciseFrom(const Json& json, std::vector<Error>& damage) {
  Exercise exercise;
  visitHead(exercise, ExerciseFieldReader(json));
  if (const Status checked = checkExercise(exercise); !checked) {
    damage.push_back(checked.error());
    exercise = Exercise();
  }
  const auto tooMany = [&](const char* what, std::size_t count, std::size_t most) {
    damage.push_back({ErrorCode::FileTooLarge, {what, std::to_string(count), std::to_string(most)}, {}, {}});
  };
  const Json &criteria = arrayAt(json, kCriteria), &steps = arrayAt(json, kSteps);
  for (const Json& each : criteria) {
    if (exercise.criteria.size() == Exercise::kMostCriteria) {
      tooMany("criteria", criteria.size(), Exercise::kMostCriteria);
      break;
    }
    MarkingCriterion& c = exercise.criteria.emplace_back();
    visitCriterion(c, ExerciseFieldReader(each));
    c.others = othersOf(each, c);
    keepIfSound(exercise, exercise.criteria, damage);
  }
  for (const Json& each : steps) {
    if (exercise.steps.size() == Exercise::kMostSteps) {
      tooMany("steps", steps.size(), Exercise::kMostSteps);
      break;
    }
    ExerciseStep& step = exercise.steps.emplace_back();
    visitStep(step, ExerciseFieldReader(each));
    step.others = othersOf(each, step);
    keepIfSound(exercise, exercise.steps, damage);
  }
  return exercise;
}

Json toJson(const Attempt& attempt) {
  Json json = {{kSeconds, attempt.seconds}, {kHintsSeen, attempt.hints}, {kStepsDone, attempt.done}};
  visitAttemptTexts(attempt, JsonFieldWriter(json));
  return json;
}

Attempt attemptFrom(const Json& json, std::vector<Error>& damage) {
  Attempt attempt;
  visitAttemptTexts(attempt, [&](const char* key, std::string& text) {
    text = stringAt(json, key);
    if (text.size() <= Attempt::kLongestText) return;
    text.clear();
    damage.push_back({ErrorCode::ElementMalformed, {key, "it is too long"}, {}, {}});
  });
  double seconds = 0.0;
  JsonFieldReader{json}(kSeconds, seconds);
  if (seconds >= 0.0 && seconds <= Exercise::kLongestTime) {
    attempt.seconds = seconds;
  } else {
    damage.push_back({ErrorCode::ElementMalformed, {"attempt", "its time is impossible"}, {}, {}});
  }
  for (const Json& each : arrayAt(json, kHintsSeen)) {
    if (attempt.hints.size() == Exercise::kMostSteps) break;
    const auto count = each.is_number_unsigned() ? each.get<std::uint64_t>() : 0;
    attempt.hints.push_back(static_cast<std::size_t>(std::min<std::uint64_t>(count, Exercise::kMostHints)));
  }
  for (const Json& each : arrayAt(json, kStepsDone)) {
    if (attempt.done.size() < Exercise::kMostSteps) attempt.done.push_back(each.is_boolean() && each.get<bool>());
  }
  return attempt;
}

}  // namespace handwheel
