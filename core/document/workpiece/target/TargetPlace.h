// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Note.h"
#include "document/Property.h"
#include "document/workpiece/WorkpieceSnapshot.h"

namespace handwheel {

// Where a target lies in its bar. Its finished face, which is the zero of the drawing and of programs, is behind the
// free end of the bar by what is left there for facing. All lengths are in mm.

inline constexpr double kUsualAllowance = 1.0;
inline constexpr const char* kAllowanceId = "facing_allowance";

// What is left for facing; negative where the target goes beyond the bar.
double allowanceOf(const TargetProfile& target, const StockCylinder& stock);
// The usual allowance, or what the bar has where that is less.
double usualAllowance(const TargetProfile& target, const StockCylinder& stock);
// The target moved to another allowance.
TargetProfile withAllowance(const TargetProfile& target, const StockCylinder& stock, double allowance);

// Z of program zero in the coordinates of the document: the finished face of the target, or the free end of the bar.
double programZero(const WorkpieceSnapshot& workpiece);
// From where Z is shown, mm above the lower end of the bar. In work on an exercise it is program zero, as in its task
// and its marks; else the lower end itself.
double shownZero(const WorkpieceSnapshot& workpiece, bool isOfExercise);
// How far the bar goes beyond program zero: 0 without a target.
double programAllowance(const WorkpieceSnapshot& workpiece);

// The allowance, which can be changed, with a remark where the target does not fit into the bar; where the finished
// face is, and what is left at the chuck's end.
std::vector<Property> placeProperties(const TargetProfile& target, const StockCylinder& stock);
// Which end of the target is the free one of the bar, in words: both are named by their diameters.
Note endsNote(const TargetProfile& target);
// The target with another value of the allowance. Errors: ElementMalformed, ValueOutOfRange.
Result<TargetProfile> withPlace(const TargetProfile& target, const StockCylinder& stock, const PropertyValue& value);

}  // namespace handwheel
