// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/exercise/MarkingReport.h"

#include "document/DocumentKind.h"
#include "document/exercise/ExerciseErrors.h"
#include "document/exercise/ShippedExercises.h"
#include "document/exercise/Submission.h"
#include "report/exercise/MarkingWords.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <unordered_map>

namespace handwheel {

namespace {

using Json = nlohmann::ordered_json;

std::string verdictWord(Verdict verdict) {
  switch (verdict) {
    case Verdict::Met:
      return "met";
    case Verdict::TooSmall:
      return "too small";
    case Verdict::TooLarge:
      return "too large";
    case Verdict::NotMeasured:
      break;
  }
  return "not measured";
}

Json numberOrNull(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json jsonOf(const SubmissionsReport& report, const Mark& mark) {
  const MarkingCriterion& c = *report.exercise.find(mark.criterion);
  return {{"id", c.id},
          {"name", c.name},
          {"figure", c.figure},
          {"unit", unitOf(report, c)},
          {"lower", numberOrNull(c.lower)},
          {"upper", numberOrNull(c.upper)},
          {"measured", numberOrNull(mark.value)},
          {"verdict", verdictWord(mark.verdict)},
          {"points", mark.points},
          {"of", mark.of},
          {"reason", mark.reason.inEnglish()},
          {"remark", mark.remark.inEnglish()}};
}

Json jsonOf(const SubmissionsReport& report, const ReportMeasurement& each) {
  const MeasurementType* const type = measurementType(report.figures, each.figure);
  return {{"figure", each.figure}, {"unit", type ? type->unit : std::string()}, {"measured", each.value}};
}

// Returns the damage of a file that was handed in: the teacher must know it before giving no points.
std::vector<std::string> damageRemarks(const DocumentFile& file, std::string (*describe)(const Error&)) {
  std::vector<std::string> remarks;
  for (const Error& error : file.damage) remarks.push_back("The file is damaged: " + describe(error));
  if (file.unlistedDamage > 0)
    remarks.push_back("The file has more damage: " + std::to_string(file.unlistedDamage) + " further places.");
  return remarks;
}

constexpr double kLargerPart = 0.5;  // share of what was moved by hand

bool isSameRecording(const std::vector<RecordedPiece>& a, const std::vector<RecordedPiece>& b) {
  return !a.empty() && std::ranges::equal(a, b, {}, &RecordedPiece::fingerprint, &RecordedPiece::fingerprint);
}

// Number of occurrences, in each work of a class, of each piece that was moved by hand.
using HandPieces = std::unordered_map<std::uint64_t, std::map<std::size_t, std::size_t>>;

HandPieces handPiecesOf(const std::vector<ReportedWork>& works) {
  HandPieces pieces;
  for (std::size_t i = 0; i < works.size(); ++i)
    for (const RecordedPiece& piece : works[i].details.pieces)
      if (piece.isByHand) ++pieces[piece.fingerprint][i];
  return pieces;
}

// The shares of what was moved by hand in a work that the others have, too, by time; each of their pieces counts once.
std::vector<double> sharedByHand(const std::vector<ReportedWork>& works, std::size_t work, const HandPieces& pieces) {
  std::vector<double> shares(works.size(), 0.0);
  std::unordered_map<std::uint64_t, std::size_t> seen;
  double all = 0.0;
  for (const RecordedPiece& piece : works[work].details.pieces) {
    if (!piece.isByHand) continue;
    all += piece.seconds;
    const std::size_t before = seen[piece.fingerprint]++;
    for (const auto& [other, count] : pieces.at(piece.fingerprint))
      if (before < count) shares[other] += piece.seconds;
  }
  for (double& share : shares) share = all > 0.0 ? share / all : 0.0;
  return shares;
}

}  // namespace

ReportedWork markFile(const ExerciseSnapshot& scheme, std::uint64_t mark, const std::filesystem::path& path,
                      const DocumentKinds& kinds, std::string (*describe)(const Error&), Progress progress) {
  ReportedWork work;
  work.row.file = path.filename().string();
  std::error_code ignored;
  work.path = std::filesystem::absolute(path, ignored).string();
  work.scheme = mark;
  const Result<OpenedFile> opened = kinds.open(path, {}, progress.part(0.0, 0.3));
  const auto submission = opened ? std::dynamic_pointer_cast<const ExerciseSnapshot>(opened->content) : nullptr;
  const auto marked = [&]() -> Result<SubmissionRow> {
    if (!opened) return opened.error();
    if (!submission) return Error{ExerciseError::NotHandedIn, {}, {}, {}};
    return markSubmission(scheme, *submission, work.row.file, progress.part(0.3, 0.7));
  };
  if (opened) work.row.remarks = damageRemarks(opened->file, describe);
  if (Result<SubmissionRow> row = marked()) {
    row->remarks.insert(row->remarks.begin(), work.row.remarks.begin(), work.row.remarks.end());
    work.row = std::move(row.value());
    work.details = scheme.subject->details(*scheme.task, *submission->work, progress.part(0.7, 1.0));
    return work;
  } else {
    Error error = row.error();
    error.subject.clear();
    work.row.problem = describe(error);
  }
  if (submission && submission->attempt) work.row.attempt = *submission->attempt;
  return work;
}

void remarkEqualWorks(std::vector<ReportedWork>& works) {
  const auto nameOf = [](const SubmissionRow& row) {
    return row.attempt.student.empty() ? row.file : row.attempt.student + " (" + row.file + ")";
  };
  const HandPieces pieces = handPiecesOf(works);
  for (std::size_t i = 0; i < works.size(); ++i) {
    const std::vector<double> shares = sharedByHand(works, i, pieces);
    for (std::size_t j = 0; j < works.size(); ++j) {
      if (i == j) continue;
      std::vector<std::string>& remarks = works[i].row.remarks;
      if (works[i].details.seconds > 0.0 && isSameRecording(works[i].details.pieces, works[j].details.pieces)) {
        remarks.push_back("The recording is the same as that of " + nameOf(works[j].row) + ".");
      } else if (shares[j] > kLargerPart) {
        remarks.push_back(std::to_string(static_cast<int>(100.0 * shares[j])) +
                          " % of the recording is the same as in that of " + nameOf(works[j].row) + ".");
      }
    }
  }
}

SubmissionsReport submissionsReportOf(const ExerciseSnapshot& exercise) {
  SubmissionsReport report{inLanguage(exercise), measurementTypes(*exercise.subject), {}};
  if (!exercise.marked) return report;
  const std::uint64_t scheme = schemeMark(exercise);
  const std::uint64_t older = schemeMark(exercise.exercise);  // mark of older versions, without the task
  for (const auto& work : *exercise.marked) {
    report.works.push_back(*work);
    if (work->scheme != scheme && work->scheme != older && work->row.problem.empty())
      report.works.back().row.remarks.emplace_back(
          "The exercise was changed after it was marked: mark its file again.");
  }
  remarkEqualWorks(report.works);
  return report;
}

Json toJson(const SubmissionsReport& report) {
  Json works = Json::array();
  for (const ReportedWork& work : report.works) {
    const SubmissionRow& row = work.row;
    Json json = {{"file", row.file},
                 {"student", row.attempt.student},
                 {"handed_in", row.attempt.handedIn},
                 {"seconds", row.attempt.seconds},
                 {"recorded_s", work.details.seconds},
                 {"hints", row.attempt.hintCount()}};
    json["made_by"] =
        row.origin == WorkOrigin::Unknown ? Json() : Json(kOriginNames[static_cast<std::size_t>(row.origin)]);
    json["tries"] = row.tries ? Json(*row.tries) : Json();
    json["problem"] = row.problem.empty() ? Json() : Json(row.problem);
    json["remarks"] = row.remarks;
    json["points"] = row.marking.points;
    json["of"] = row.marking.of;
    json["marks"] = Json::array();
    for (const Mark& mark : row.marking.marks) json["marks"].push_back(jsonOf(report, mark));
    json["figures"] = Json::array();
    for (const ReportMeasurement& each : work.details.figures) json["figures"].push_back(jsonOf(report, each));
    json["events"] = Json::array();
    for (const ReportEvent& event : work.details.events)
      json["events"].push_back(
          {{"time_s", event.seconds ? Json(*event.seconds) : Json()}, {"text", event.text.inEnglish()}});
    works.push_back(std::move(json));
  }
  return {{"exercise", report.exercise.title}, {"of", report.exercise.points()}, {"submissions", std::move(works)}};
}

std::string readableText(const SubmissionsReport& report) {
  std::string text;
  for (const ReportedWork& work : report.works) {
    const SubmissionRow& row = work.row;
    text +=
        (text.empty() ? "" : "\n") + row.file + (row.attempt.student.empty() ? "" : ", " + row.attempt.student) + ": ";
    text += (row.problem.empty() ? pointsText(row.marking) : "not marked: " + row.problem) + "\n";
    for (const std::string& remark : row.remarks) text += "  " + remark + "\n";
    if (!row.problem.empty()) continue;
    for (const auto& cells : rowsOf(report, row.marking))
      text += "  " + cells[3] + "  " + cells[0] + ": " + cells[4] + "\n";
    for (const ReportEvent& event : work.details.events) text += "  " + momentOf(event) + event.text.inEnglish() + "\n";
  }
  return text;
}

}  // namespace handwheel
