// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/StartedWork.h"

#include "base/JsonText.h"
#include "document/exercise/ExerciseJson.h"

#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

constexpr const char* kBegunFrom = "begun_from";  // in the attempt: id of a document

}  // namespace

AssignedExercise assignmentOf(const ExerciseSnapshot& exercise, const Attempt& attempt, const std::string& begunFrom) {
  AssignedExercise assigned;
  assigned.description = std::make_shared<const nlohmann::json>(ExerciseKind::description(forStudents(exercise)));
  nlohmann::json json = toJson(attempt);
  if (!begunFrom.empty()) json[kBegunFrom] = begunFrom;
  assigned.attempt = std::make_shared<const nlohmann::json>(std::move(json));
  return assigned;
}

AssignedExercise withAttempt(const AssignedExercise& assigned, const Attempt& attempt) {
  nlohmann::json json = *assigned.attempt;
  json.update(toJson(attempt));
  return {assigned.description, std::make_shared<const nlohmann::json>(std::move(json))};
}

Result<std::shared_ptr<const ExerciseSnapshot>> exerciseOf(const ExerciseKind& kind, const AssignedExercise& assigned) {
  nlohmann::json description = *assigned.description;
  if (description.is_object()) description.erase("solution");  // a student has none
  Result<SnapshotPointer> made = kind.fromDescription(description, {});
  if (!made) return made.error();
  return begunCopy(static_cast<const ExerciseSnapshot&>(**made), assigned);
}

std::shared_ptr<const ExerciseSnapshot> begunCopy(const ExerciseSnapshot& exercise, const AssignedExercise& assigned) {
  ExerciseSnapshot copy = forStudents(exercise);
  std::vector<Error> damage;
  copy.attempt = attemptFrom(*assigned.attempt, damage);
  return std::make_shared<const ExerciseSnapshot>(std::move(copy));
}

bool isSameExercise(const AssignedExercise& one, const AssignedExercise& other) {
  return one && other && (one.description == other.description || *one.description == *other.description);
}

bool isBegunFrom(const AssignedExercise& work, const DocumentFile& exercise) {
  if (!work) return false;
  const std::string from = stringAt(*work.attempt, kBegunFrom);
  const bool isDescription = !exercise.path.empty() && !exercise.isContainer;
  return from.empty() || from == exercise.id || isDescription;
}

}  // namespace handwheel
