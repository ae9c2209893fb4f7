// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/AssignedExercise.h"
#include "document/exercise/ExerciseKind.h"

namespace handwheel {

// Returns the copy of an exercise to store in a document of work. It is always a student's copy, so that nobody finds
// the answers there. begunFrom: id of the document that it was begun from; empty: unknown.
AssignedExercise assignmentOf(const ExerciseSnapshot& exercise, const Attempt& attempt,
                              const std::string& begunFrom = {});

// Returns the same exercise with another attempt. Unknown keys of the file are kept.
AssignedExercise withAttempt(const AssignedExercise& assigned, const Attempt& attempt);

// Returns the exercise that a document is work on, with the attempt and without the work. Accepts any input. Errors:
// those of ExerciseKind::fromDescription().
Result<std::shared_ptr<const ExerciseSnapshot>> exerciseOf(const ExerciseKind& kind, const AssignedExercise& assigned);

// Does the same for an exercise in memory whose assignmentOf() this is: only the attempt is read.
std::shared_ptr<const ExerciseSnapshot> begunCopy(const ExerciseSnapshot& exercise, const AssignedExercise& assigned);

// Returns true if both are work on the same exercise, as a student sees it.
bool isSameExercise(const AssignedExercise& one, const AssignedExercise& other);

// Returns true if the work may have been begun from the document with this file. Work without an id of its document
// matches any, and a description has another id each time it is read.
bool isBegunFrom(const AssignedExercise& work, const DocumentFile& exercise);

}  // namespace handwheel
