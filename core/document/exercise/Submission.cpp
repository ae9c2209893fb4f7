// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/Submission.h"

#include "document/exercise/ExerciseErrors.h"
#include "document/exercise/ExerciseJson.h"

#include <QDateTime>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <tuple>

namespace handwheel {

namespace {

// Returns true if the criteria that the student could read are the marked ones; texts and points may differ.
bool isSameScheme(const ExerciseSnapshot& scheme, const ExerciseSnapshot& submission) {
  const std::vector<MarkingCriterion> mine = withoutAnswers(scheme.exercise).criteria;
  const std::vector<MarkingCriterion>& theirs = submission.exercise.criteria;
  const auto isSame = [](const MarkingCriterion& a, const MarkingCriterion& b) {
    return std::tie(a.id, a.figure, a.arguments, a.lower, a.upper) ==
           std::tie(b.id, b.figure, b.arguments, b.lower, b.upper);
  };
  return std::equal(mine.begin(), mine.end(), theirs.begin(), theirs.end(), isSame);
}

// Returns how a submission was made by another version of the exercise, as an English sentence; empty: it was not, or
// in texts and points alone. What is allowed is judged by the scheme, in remarks of its own.
std::string versionRemark(const ExerciseSnapshot& scheme, const ExerciseSnapshot& submission) {
  const char* const kOtherSizes =
      "It was done by another version of the exercise: its sizes or its stock are not these.";
  nlohmann::json mine = scheme.subject->toJson(*scheme.task), theirs = submission.subject->toJson(*submission.task);
  for (const char* const rule : {"programs", "commands"}) mine.erase(rule), theirs.erase(rule);
  if (!isSameScheme(scheme, submission)) return kOtherSizes;
  if (mine == theirs) return {};
  for (const char* const condition : {"spindle_speed", "chuck_height", "chuck_diameter", "largest_feed", "force_limit",
                                      "power_limit", "material", "tools"})
    mine.erase(condition), theirs.erase(condition);
  if (mine != theirs) return kOtherSizes;
  return "It was done by another version of the exercise: its machine, its tools or its material are not these.";
}

}  // namespace

Result<ExerciseSnapshot> handedIn(ExerciseSnapshot exercise, SnapshotPointer work, Attempt attempt) {
  const Status fits = exercise.subject->checkWork(*exercise.task, *work);
  if (!fits) return fits.error();
  ExerciseSnapshot submission = forStudents(std::move(exercise));
  submission.work = std::move(work);
  if (attempt.handedIn.empty()) attempt.handedIn = presentTime();
  submission.attempt = std::move(attempt);
  return submission;
}

Result<SubmissionRow> markSubmission(const ExerciseSnapshot& scheme, const ExerciseSnapshot& submission,
                                     std::string file, Progress progress) {
  if (scheme.isForStudents) return Error{ExerciseError::WithoutScheme, {}, {}, {}};
  if (!submission.work || !submission.attempt) return Error{ExerciseError::NotHandedIn, {}, {}, file};
  if (submission.key != scheme.key) return Error{ExerciseError::OtherExercise, {submission.exercise.title}, {}, file};
  const Status fits = scheme.subject->checkWork(*scheme.task, *submission.work);
  if (!fits) {
    Error error = fits.error();
    error.subject = file;
    return error;
  }
  SubmissionRow row;
  row.file = std::move(file);
  row.attempt = *submission.attempt;
  if (std::string remark = versionRemark(scheme, submission); !remark.empty()) row.remarks.push_back(std::move(remark));
  row.origin = scheme.subject->originOf(*submission.work);
  row.tries = scheme.subject->triesOf(*submission.work);
  if (includes(row.origin, WorkOrigin::Program) && !scheme.subject->areProgramsAllowed(*scheme.task))
    row.remarks.emplace_back(row.origin == WorkOrigin::Program
                                 ? "It was cut by a program, which this exercise does not allow."
                                 : "Part of it was cut by a program, which this exercise does not allow.");
  if (includes(row.origin, WorkOrigin::Command) && !scheme.subject->areCommandsAllowed(*scheme.task))
    row.remarks.emplace_back(row.origin == WorkOrigin::Command
                                 ? "It was made by a command, which this exercise does not allow."
                                 : "Part of it was made by a command, which this exercise does not allow.");
  row.marking = markWork(scheme, *submission.work, row.attempt, progress);
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return row;
}

std::string presentTime() {
  return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
}

}  // namespace handwheel
