// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The codes of errors of exercises.
namespace handwheel::ExerciseError {

extern const ErrorDescription SubjectUnknown;  // {subject} work that this program does not know
extern const ErrorDescription OtherExercise;   // {title} what was handed in belongs to another exercise
extern const ErrorDescription OtherWork;       // {reason} the work cannot be of this exercise
extern const ErrorDescription NotHandedIn;     // the file is no work that was handed in
extern const ErrorDescription WithoutScheme;   // the exercise is a student's, which has no marking scheme
extern const ErrorDescription WithoutTarget;   // the exercise has no target that could be drawn
extern const ErrorDescription NothingTurned;   // the work that is to become the target is the untouched bar
extern const ErrorDescription NothingDrilled;  // the work whose hole is to become the planned path has none
extern const ErrorDescription FieldRefused;    // {field, in the words of the window, what is wrong}
extern const ErrorDescription MarkUnknown;     // {step, what is no mark, the marks} a step is to wait for it
extern const ErrorDescription Fixed;           // a student's copy cannot be changed

}  // namespace handwheel::ExerciseError
