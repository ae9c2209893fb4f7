// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/WorkpieceErrors.h"

namespace handwheel {

const ErrorDescription WorkpieceError::SizeFixed{
    .id = "SizeFixed",
    .sentences = {translatable("ErrorText", "the bar was cut already, so its size cannot change")},
    .advice = {translatable("ErrorText", "Undo the passes to change the size, or begin with a new workpiece.")}};

const ErrorDescription WorkpieceError::BarOfExercise{
    .id = "BarOfExercise",
    .sentences = {translatable("ErrorText", "the bar is that of the exercise, so it cannot change")},
    .advice = {translatable("ErrorText", "Work with this bar. The teacher changes it in the file of the exercise.")}};

const ErrorDescription WorkpieceError::SeveralPieces{
    .id = "SeveralPieces",
    .sentences = {translatable("ErrorText", "the part is in %1 pieces, and the file can contain only one solid")},
    .advice = {translatable("ErrorText", "Undo the pass that separated it, or export triangles, for example STL.")}};

const ErrorDescription WorkpieceError::ClosedHollow{
    .id = "ClosedHollow",
    .sentences = {translatable("ErrorText", "the part has %1 closed hollows, which the file cannot contain")},
    .advice = {translatable("ErrorText", "Bore the part open from an end, or export triangles, for example STL.")}};

const ErrorDescription WorkpieceError::NoPasses{
    .id = "NoPasses",
    .sentences = {translatable("ErrorText", "nothing was cut yet, so there are no passes to write")},
    .advice = {translatable("ErrorText", "Cut the part by hand first, or make cycles for a target.")}};

const ErrorDescription WorkpieceError::BoredPasses{
    .id = "BoredPasses",
    .sentences = {translatable("ErrorText", "passes in a bore cannot be written as a program")},
    .advice = {translatable("ErrorText", "Write a program of your own for the bore.")}};

const ErrorDescription WorkpieceError::OtherTools{
    .id = "OtherTools",
    .sentences = {translatable("ErrorText",
                               "pass %1 was made with a tool that no program moves: a drill, a file, paper or a disk")},
    .advice = {translatable("ErrorText", "Write passes that were made with turning tools.")}};

}  // namespace handwheel
