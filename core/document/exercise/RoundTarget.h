// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "document/exercise/ExerciseSubject.h"

namespace handwheel {

// Returns the operation that rounds the sizes of an exercise's target. Its parameters, both in mm, are "round-target",
// the step, and "sharp-corners", the largest fillet that becomes a sharp corner.
const Operation& roundTargetOperation();

// Calls ExerciseSubject::withRoundedTarget() with the values of that operation.
Result<ExerciseSubject::RoundedTask> withRoundedTarget(const ExerciseSubject& subject, const ExerciseTask& task,
                                                       const OperationValues& values);

}  // namespace handwheel
