// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/MarkedSubmissions.h"

#include "base/Fingerprint.h"
#include "base/JsonFields.h"
#include "base/JsonText.h"
#include "document/exercise/ExerciseJson.h"
#include "document/exercise/ExerciseSnapshot.h"

#include <QByteArray>
#include <QString>
#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <optional>

namespace handwheel {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostClassTexts = 1000;        // limit of each kind in a row
constexpr std::size_t kMostClassPieces = 1'000'000;  // limit of a recording

constexpr std::array<const char*, 4> kVerdictWords = {"met", "too_small", "too_large", "not_measured"};

constexpr const char *kClassPath = "path", *kClassAttempt = "attempt", *kClassMarks = "marks", *kClassPoints = "points",
                     *kClassOf = "of", *kClassOrigin = "made_by", *kClassTries = "tries", *kClassProblem = "problem",
                     *kClassRemarks = "remarks", *kClassScheme = "scheme", *kClassFigures = "figures",
                     *kClassEvents = "events", *kClassSeconds = "seconds", *kClassPieces = "pieces",
                     *kClassText = "text", *kClassArguments = "arguments", *kClassCriterion = "criterion",
                     *kClassVerdict = "verdict", *kClassValue = "value", *kClassReason = "reason",
                     *kClassRemark = "remark", *kClassFigure = "figure";

// Names of files and messages of libraries may be anything; JSON must be UTF-8.
std::string soundText(const std::string& text) {
  return QString::fromStdString(text).toStdString();
}

std::string classTextIn(const Json& object, const char* key) {
  std::string text = stringAt(object, key);
  return text.size() <= Exercise::kLongestText ? text : std::string();
}

double classNumberIn(const Json& object, const char* key) {
  double number = 0.0;
  JsonFieldReader{object}(key, number);
  return number;
}

// None where there is no number.
std::optional<double> classSecondsIn(const Json& object) {
  if (!JsonFieldReader(object).member(kClassSeconds).is_number()) return std::nullopt;
  return classNumberIn(object, kClassSeconds);
}

// Returns the elements of an array under a key, up to a limit.
std::vector<Json> classElementsOf(const Json& object, const char* key, std::size_t most) {
  const Json& found = JsonFieldReader(object).member(key);
  if (!found.is_array()) return {};
  // With braces, the two iterators could be taken for elements.
  return std::vector<Json>(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(std::min(found.size(), most)));
}

std::vector<std::string> classTextsIn(const Json& object, const char* key) {
  std::vector<std::string> texts;
  for (const Json& each : classElementsOf(object, key, kMostClassTexts))
    if (each.is_string()) texts.push_back(each.get<std::string>());
  return texts;
}

std::vector<std::string> soundTexts(std::vector<std::string> texts) {
  for (std::string& text : texts) text = soundText(text);
  return texts;
}

Json exerciseTextJson(const ExerciseText& text) {
  return {{kClassText, soundText(text.text)}, {kClassArguments, soundTexts(text.arguments)}};
}

ExerciseText exerciseTextIn(const Json& object, const char* key) {
  const Json& text = JsonFieldReader(object).member(key);
  return {classTextIn(text, kClassText), classTextsIn(text, kClassArguments)};
}

template <std::size_t N>
std::size_t classWordAt(const std::array<const char*, N>& words, const std::string& word, std::size_t otherwise) {
  const auto found = std::find(words.begin(), words.end(), word);
  return found == words.end() ? otherwise : static_cast<std::size_t>(found - words.begin());
}

Json markJson(const Mark& mark) {
  return {{kClassCriterion, mark.criterion},
          {kClassVerdict, kVerdictWords[static_cast<std::size_t>(mark.verdict)]},
          {kClassValue, mark.value ? Json(*mark.value) : Json()},
          {kClassPoints, mark.points},
          {kClassOf, mark.of},
          {kClassReason, exerciseTextJson(mark.reason)},
          {kClassRemark, exerciseTextJson(mark.remark)}};
}

Mark markFrom(const Json& json) {
  Mark mark;
  mark.criterion = classTextIn(json, kClassCriterion);
  mark.verdict = static_cast<Verdict>(
      classWordAt(kVerdictWords, stringAt(json, kClassVerdict), static_cast<std::size_t>(Verdict::NotMeasured)));
  if (const Json& value = JsonFieldReader(json).member(kClassValue); value.is_number())
    mark.value = value.get<double>();
  mark.points = classNumberIn(json, kClassPoints);
  mark.of = classNumberIn(json, kClassOf);
  mark.reason = exerciseTextIn(json, kClassReason);
  mark.remark = exerciseTextIn(json, kClassRemark);
  return mark;
}

Json workJson(const ReportedWork& work) {
  const SubmissionRow& row = work.row;
  Json json = {{kClassPath, QByteArray::fromStdString(work.path).toPercentEncoding("/ ").toStdString()},
               {kClassAttempt, toJson(row.attempt)},
               {kClassPoints, row.marking.points},
               {kClassOf, row.marking.of},
               {kClassOrigin, kOriginNames[static_cast<std::size_t>(row.origin)]},
               {kClassProblem, soundText(row.problem)},
               {kClassRemarks, soundTexts(row.remarks)},
               {kClassScheme, work.scheme},
               {kClassSeconds, work.details.seconds}};
  if (row.tries) json[kClassTries] = *row.tries;
  Json marks = Json::array(), figures = Json::array(), events = Json::array(), pieces = Json::array();
  for (const Mark& mark : row.marking.marks) marks.push_back(markJson(mark));
  for (const ReportMeasurement& each : work.details.figures)
    figures.push_back({{kClassFigure, each.figure}, {kClassValue, each.value}});
  for (const ReportEvent& event : work.details.events) {
    Json stored = Json::object();
    if (event.seconds) stored[kClassSeconds] = *event.seconds;
    stored[kClassText] = exerciseTextJson(event.text);
    events.push_back(std::move(stored));
  }
  for (const RecordedPiece& piece : work.details.pieces)
    pieces.push_back(Json::array({piece.fingerprint, piece.seconds, piece.isByHand}));
  json[kClassMarks] = std::move(marks);
  json[kClassFigures] = std::move(figures);
  json[kClassEvents] = std::move(events);
  json[kClassPieces] = std::move(pieces);
  return json;
}

ReportedWork workFrom(const Json& json, std::vector<Error>& damage) {
  ReportedWork work;
  work.isKept = true;
  work.path = QByteArray::fromPercentEncoding(QByteArray::fromStdString(classTextIn(json, kClassPath))).toStdString();
  work.scheme = countAt(json, kClassScheme);
  SubmissionRow& row = work.row;
  row.file = std::filesystem::path(work.path).filename().string();
  row.attempt = attemptFrom(JsonFieldReader(json).member(kClassAttempt), damage);
  row.origin = static_cast<WorkOrigin>(classWordAt(kOriginNames, stringAt(json, kClassOrigin), 0));
  if (const Json& tries = JsonFieldReader(json).member(kClassTries); tries.is_number_unsigned())
    row.tries = tries.get<std::size_t>();
  row.problem = classTextIn(json, kClassProblem);
  row.remarks = classTextsIn(json, kClassRemarks);
  row.marking.points = classNumberIn(json, kClassPoints);
  row.marking.of = classNumberIn(json, kClassOf);
  for (const Json& each : classElementsOf(json, kClassMarks, Exercise::kMostCriteria))
    row.marking.marks.push_back(markFrom(each));
  for (const Json& each : classElementsOf(json, kClassFigures, kMostClassTexts))
    work.details.figures.push_back({classTextIn(each, kClassFigure), classNumberIn(each, kClassValue)});
  for (const Json& each : classElementsOf(json, kClassEvents, kMostClassTexts))
    work.details.events.push_back({classSecondsIn(each), exerciseTextIn(each, kClassText)});
  work.details.seconds = classNumberIn(json, kClassSeconds);
  for (const Json& each : classElementsOf(json, kClassPieces, kMostClassPieces)) {
    if (!each.is_array() || each.size() != 3 || !each[0].is_number_unsigned() || !each[1].is_number() ||
        !each[2].is_boolean())
      continue;
    work.details.pieces.push_back({each[0].get<std::uint64_t>(), each[1].get<double>(), each[2].get<bool>()});
  }
  return work;
}

}  // namespace

std::uint64_t schemeMark(const Exercise& exercise) {
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  Fingerprint mark;
  for (const MarkingCriterion& c : exercise.criteria) {
    mark.add(c.id);
    mark.add(c.figure);
    mark.add(static_cast<std::uint64_t>(c.arguments.size()));
    for (const double argument : c.arguments) mark.add(argument);
    for (const double value : {c.lower.value_or(-kNoLimit), c.upper.value_or(kNoLimit), c.points, c.slack})
      mark.add(value + 0.0);  // -0 is 0
    mark.add(static_cast<std::uint64_t>(c.isDecisive));
  }
  return mark.value();
}

std::uint64_t schemeMark(const ExerciseSnapshot& exercise) {
  Fingerprint mark;
  mark.add(schemeMark(exercise.exercise));
  mark.add(exercise.subject->toJson(*exercise.task).dump(-1, ' ', false, Json::error_handler_t::replace));
  return mark.value();
}

MarkedSubmissions withMarked(MarkedSubmissions marked, std::vector<ReportedWork> more) {
  for (ReportedWork& each : more) {
    const auto isOfFile = [&](const auto& work) { return work->path == each.path; };
    const auto before = std::find_if(marked.begin(), marked.end(), isOfFile);
    auto made = std::make_shared<const ReportedWork>(std::move(each));
    if (before != marked.end())
      *before = std::move(made);
    else if (marked.size() < kMostMarkedWorks)
      marked.push_back(std::move(made));
  }
  return marked;
}

Json toJson(const MarkedSubmissions& marked) {
  Json json = Json::array();
  for (const auto& work : marked) json.push_back(workJson(*work));
  return json;
}

MarkedSubmissions markedSubmissionsFrom(const Json& json, std::vector<Error>& damage) {
  MarkedSubmissions marked;
  if (!json.is_array()) {
    if (!json.is_null()) damage.push_back({ErrorCode::ElementMalformed, {"class", "a list was expected"}, {}, {}});
    return marked;
  }
  for (const Json& each : json) {
    if (marked.size() == kMostMarkedWorks) {
      damage.push_back(
          {ErrorCode::FileTooLarge, {"rows", std::to_string(json.size()), std::to_string(kMostMarkedWorks)}, {}, {}});
      break;
    }
    if (each.is_object())
      marked.push_back(std::make_shared<const ReportedWork>(workFrom(each, damage)));
    else
      damage.push_back({ErrorCode::ElementMalformed, {"class", "an object was expected"}, {}, {}});
  }
  return marked;
}

}  // namespace handwheel
