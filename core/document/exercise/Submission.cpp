// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/Submission.h"

#include "document/exercise/ExerciseErrors.h"
#include "document/exercise/ExerciseJson.h"

#include <QDateTime>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

// Whether what the student was told is what is marked; texts and points may be others.
bool isSameScheme(const ExerciseSnapshot& scheme, const ExerciseSnapshot& submission) {
  const auto judged = [](const Exercise& exercise) {
    nlohmann::json all = nlohmann::json::array();
    for (const nlohmann::json& c : toJson(withoutAnswers(exercise))["criteria"])
      all.push_back({c["id"], c["figure"], c["arguments"], c["lower"], c["upper"]});
    return all;
  };
  return judged(scheme.exercise) == judged(submission.exercise) &&
         scheme.subject->toJson(*scheme.task) == submission.subject->toJson(*submission.task);
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

Result<ClassRow> markSubmission(const ExerciseSnapshot& scheme, const ExerciseSnapshot& submission, std::string file,
                                Progress progress) {
  if (scheme.isForStudents) return Error{ExerciseError::WithoutScheme, {}, {}, {}};
  if (!submission.work || !submission.attempt) return Error{ExerciseError::NotHandedIn, {}, {}, file};
  if (submission.key != scheme.key) return Error{ExerciseError::OtherExercise, {submission.exercise.title}, {}, file};
  const Status fits = scheme.subject->checkWork(*scheme.task, *submission.work);
  if (!fits) {
    Error error = fits.error();
    error.subject = file;
    return error;
  }
  ClassRow row;
  row.file = std::move(file);
  row.attempt = *submission.attempt;
  if (!isSameScheme(scheme, submission))
    row.remarks.emplace_back("It was done by another version of the exercise: its sizes or its stock are not these.");
  row.marking = markWork(scheme, *submission.work, row.attempt, progress);
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return row;
}

std::string presentTime() {
  return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
}

}  // namespace handwheel
