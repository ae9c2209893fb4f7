// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/AssignedExercise.h"
#include "document/exercise/ExerciseKind.h"

namespace handwheel {

// Returns the copy of an exercise to store in a document of work. It is always a student's copy, so the document of the
// work contains no answers. begunFrom: the id of the document from which the work was begun; empty: unknown.
AssignedExercise assignmentOf(const ExerciseSnapshot& exercise, const Attempt& attempt,
                              const std::string& begunFrom = {});

// Returns an assigned exercise with another attempt. Unknown keys of the file are kept.
AssignedExercise withAttempt(const AssignedExercise& assigned, const Attempt& attempt);

// Returns the exercise that a document is work on, with the attempt and without the work. Accepts any input. Errors:
// the errors of ExerciseKind::fromDescription().
Result<std::shared_ptr<const ExerciseSnapshot>> exerciseOf(const ExerciseKind& kind, const AssignedExercise& assigned);

// Returns the student's copy of an exercise in memory with the attempt in `assigned`, which must be an assignmentOf()
// this exercise. Only the attempt is read.
std::shared_ptr<const ExerciseSnapshot> begunCopy(const ExerciseSnapshot& exercise, const AssignedExercise& assigned);

// Returns true if two assigned exercises are the same as a student sees them.
bool isSameExercise(const AssignedExercise& one, const AssignedExercise& other);

// Returns true if the work may have been begun from the document with this file. Work that does not name the id of its
// document matches any document. Any work matches a document that was opened from a description, because its id is new
// each time it is opened.
bool isBegunFrom(const AssignedExercise& work, const DocumentFile& exercise);

}  // namespace handwheel
