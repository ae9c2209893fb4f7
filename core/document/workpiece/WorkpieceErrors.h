// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// Error codes of workpieces.
namespace handwheel::WorkpieceError {

extern const ErrorDescription SizeFixed;      // the bar was cut, so its size cannot change
extern const ErrorDescription BarOfExercise;  // the bar is work on an exercise, whose file defines it
extern const ErrorDescription ClosedHollow;   // {hollows}: the format cannot store a solid with closed hollows

extern const ErrorDescription NoPasses;    // no pass can be written as a program
extern const ErrorDescription OtherTools;  // all passes were made with tools that no program can use

}  // namespace handwheel::WorkpieceError
