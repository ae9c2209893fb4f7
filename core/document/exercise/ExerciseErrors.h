// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// Error codes of exercises.
namespace handwheel::ExerciseError {

extern const ErrorDescription SubjectUnknown;  // {subject}: the program does not know this kind of work
extern const ErrorDescription OtherExercise;   // {title}: the submission belongs to another exercise
extern const ErrorDescription OtherWork;       // {reason}: the work cannot belong to this exercise
extern const ErrorDescription NotHandedIn;     // the file is not a submission
extern const ErrorDescription WithoutScheme;   // the exercise is a student's copy, which has no marking scheme
extern const ErrorDescription WithoutTarget;   // the exercise has no target to draw
extern const ErrorDescription NothingTurned;   // the work that is to become the target is the uncut bar
extern const ErrorDescription NothingDrilled;  // the work that is to become the planned path has no hole
extern const ErrorDescription FieldRefused;    // {field in the window's words, problem}: a field has an invalid value
extern const ErrorDescription MarkUnknown;     // {step, unknown name, known names}: a step lists an unknown criterion
extern const ErrorDescription Fixed;           // a student's copy cannot be changed

}  // namespace handwheel::ExerciseError
