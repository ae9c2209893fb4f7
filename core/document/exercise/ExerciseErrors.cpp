// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/ExerciseErrors.h"

namespace handwheel {

const ErrorDescription ExerciseError::SubjectUnknown{
    .id = "SubjectUnknown",
    .sentences = {translatable("ErrorText", "the exercise is about “%1”, which this program cannot mark"),
                  translatable("ErrorText", "the exercise does not specify its subject")},
    .advice = {translatable("ErrorText", "Open it with a newer version of the program.")}};

const ErrorDescription ExerciseError::OtherExercise{
    .id = "OtherExercise",
    .sentences = {translatable("ErrorText", "it was handed in for another exercise, “%1”")},
    .advice = {translatable("ErrorText", "Mark it with the exercise that the student's file was made from.")}};

const ErrorDescription ExerciseError::OtherWork{
    .id = "OtherWork",
    .sentences = {translatable("ErrorText", "the work does not belong to this exercise: %1")},
    .advice = {translatable("ErrorText", "Begin the exercise from its file, and hand in that work.")}};

const ErrorDescription ExerciseError::NotHandedIn{
    .id = "NotHandedIn",
    .sentences = {translatable("ErrorText", "it has no work that was handed in")},
    .advice = {translatable("ErrorText", "Ask the student to hand in the exercise once more.")}};

const ErrorDescription ExerciseError::WithoutScheme{
    .id = "WithoutScheme",
    .sentences = {translatable("ErrorText", "it is a student's copy, which has no marking scheme")},
    .advice = {translatable("ErrorText", "Give the teacher's file of the exercise.")}};

const ErrorDescription ExerciseError::WithoutTarget{
    .id = "WithoutTarget",
    .sentences = {translatable("ErrorText", "the exercise has no target, so there is nothing to draw")},
    .advice = {translatable("ErrorText", "Import a target, or turn a model solution and take it as the target.")}};

const ErrorDescription ExerciseError::NothingTurned{
    .id = "NothingTurned",
    .sentences = {translatable("ErrorText", "nothing was turned in this work; it is the bar itself")},
    .advice = {translatable("ErrorText", "Turn the part first, or import the target from a drawing.")}};

const ErrorDescription ExerciseError::NothingDrilled{
    .id = "NothingDrilled",
    .sentences = {translatable("ErrorText", "nothing was drilled in this work")},
    .advice = {translatable("ErrorText", "Drill the hole first; it becomes the planned path.")}};

const ErrorDescription ExerciseError::FieldRefused{
    .id = "FieldRefused",
    .sentences = {translatable("ErrorText", "%1: %2")},
    .advice = {translatable("ErrorText", "Give this field of the exercise another value.")}};

const ErrorDescription ExerciseError::MarkUnknown{
    .id = "MarkUnknown",
    .sentences = {translatable("ErrorText", "%1: there is no mark “%2”")},
    .advice = {translatable("ErrorText", "Put “;” between the names of several marks. There are: %3."),
               translatable("ErrorText", "Add what is marked in “Criteria” first.")}};

const ErrorDescription ExerciseError::Fixed{
    .id = "Fixed",
    .sentences = {translatable("ErrorText", "a student's copy of an exercise cannot be changed")},
    .advice = {translatable("ErrorText", "Change the teacher's file and make students' copies of it again.")}};

}  // namespace handwheel
