// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/AssignedExercise.h"
#include "document/exercise/ExerciseKind.h"

namespace handwheel {

// The copy of an exercise that is stored in a document of work on it. It is the student's, whatever the work was begun
// from, so that nobody finds the answers there. begunFrom: id of the document that it was begun from; empty: unknown.
AssignedExercise assignmentOf(const ExerciseSnapshot& exercise, const Attempt& attempt,
                              const std::string& begunFrom = {});

// The same exercise with another attempt. What the file had besides the attempt's own keys stays.
AssignedExercise withAttempt(const AssignedExercise& assigned, const Attempt& attempt);

// The exercise that a document is work on, with the attempt and without the work. Any input. Errors: those of
// ExerciseKind::fromDescription().
Result<std::shared_ptr<const ExerciseSnapshot>> exerciseOf(const ExerciseKind& kind, const AssignedExercise& assigned);

// The same of an exercise that is at hand, whose assignmentOf() this is: nothing is read but the attempt.
std::shared_ptr<const ExerciseSnapshot> begunCopy(const ExerciseSnapshot& exercise, const AssignedExercise& assigned);

// Whether both are work on the same exercise, as a student sees it.
bool isSameExercise(const AssignedExercise& one, const AssignedExercise& other);

// Whether the work was begun from the document with this file, as far as one can know: work that does not say is
// anybody's, and a description has another id each time that it is read.
bool isBegunFrom(const AssignedExercise& work, const DocumentFile& exercise);

}  // namespace handwheel
