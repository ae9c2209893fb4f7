// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseSnapshot.h"
#include "exercise/SubmissionTable.h"

namespace handwheel {

// Returns a student's exercise with the work, to be handed in as a file. The result has no answers even if `exercise`
// has them. Errors: OtherWork {reason}.
Result<ExerciseSnapshot> handedIn(ExerciseSnapshot exercise, SnapshotPointer work, Attempt attempt);

// Marks a submission by the teacher's exercise. file: the name of the submission's file, for the row. Errors:
// WithoutScheme, NotHandedIn, OtherExercise {title}, OtherWork, Cancelled.
Result<SubmissionRow> markSubmission(const ExerciseSnapshot& scheme, const ExerciseSnapshot& submission,
                                     std::string file, Progress progress = {});

// Returns the present time in the format of attempts: UTC, ISO 8601.
std::string presentTime();

}  // namespace handwheel
