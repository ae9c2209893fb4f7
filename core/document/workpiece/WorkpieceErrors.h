// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The codes of errors of workpieces.
namespace handwheel::WorkpieceError {

extern const ErrorDescription SizeFixed;      // the bar was cut, so that its size cannot change
extern const ErrorDescription BarOfExercise;  // the bar is work on an exercise, and that of its file
extern const ErrorDescription ClosedHollow;   // {hollows} a solid of this format has none

extern const ErrorDescription NoPasses;    // nothing was cut yet that could be written as a program
extern const ErrorDescription OtherTools;  // {pass} it was made with a tool that no program moves

}  // namespace handwheel::WorkpieceError
