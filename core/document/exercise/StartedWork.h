// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/AssignedExercise.h"
#include "document/exercise/ExerciseKind.h"

namespace handwheel {

// The copy of an exercise that is stored in a document of work on it. It is the student's, whatever the work was begun
// from, so that nobody finds the answers there.
AssignedExercise assignmentOf(const ExerciseSnapshot& exercise, const Attempt& attempt);

// The same exercise with another attempt. What the file had besides the attempt's own keys stays.
AssignedExercise withAttempt(const AssignedExercise& assigned, const Attempt& attempt);

// The exercise that a document is work on, with the attempt and without the work. Any input. Errors: those of
// ExerciseKind::fromDescription().
Result<std::shared_ptr<const ExerciseSnapshot>> exerciseOf(const ExerciseKind& kind, const AssignedExercise& assigned);

// Whether both are work on the same exercise, as a student sees it.
bool isSameExercise(const AssignedExercise& one, const AssignedExercise& other);

}  // namespace handwheel
