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

const ErrorDescription WorkpieceError::ClosedHollow{
    .id = "ClosedHollow",
    .sentences = {translatable("ErrorText", "the part has %1 closed hollows, which the file cannot contain")},
    .advice = {translatable("ErrorText", "Bore the part open from an end, or export triangles, for example STL.")}};

const ErrorDescription WorkpieceError::NoPasses{
    .id = "NoPasses",
    .sentences = {translatable("ErrorText", "nothing was cut yet, so there are no passes to write")},
    .advice = {translatable("ErrorText", "Cut the part by hand first, or make cycles for a target.")}};

const ErrorDescription WorkpieceError::OtherTools{
    .id = "OtherTools",
    .sentences = {translatable(
        "ErrorText", "all passes were made with a file, paper or a disk, or are threads that no program can cut")},
    .advice = {translatable("ErrorText", "Write passes of tools that turn, bore or drill.")}};

}  // namespace handwheel
