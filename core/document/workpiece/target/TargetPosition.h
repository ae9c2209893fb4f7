// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Note.h"
#include "document/Property.h"
#include "document/workpiece/WorkpieceSnapshot.h"

namespace handwheel {

// Functions for the position of a target in its bar. The finished face of the target, which is the zero of the drawing
// and of programs, is behind the free end of the bar by the allowance for facing. All lengths are in mm.

inline constexpr double kUsualAllowance = 1.0;
inline constexpr const char* kAllowanceId = "facing_allowance";

// Returns the allowance for facing; negative if the target goes beyond the bar.
double allowanceOf(const TargetProfile& target, const StockCylinder& stock);
// Returns the usual allowance, or the excess length of the bar if that is less.
double usualAllowance(const TargetProfile& target, const StockCylinder& stock);
// Returns the target moved to another allowance.
TargetProfile withAllowance(const TargetProfile& target, const StockCylinder& stock, double allowance);

// Returns Z of program zero in the coordinates of the document: the finished face of the target, or the free end of the
// bar.
double programZero(const WorkpieceSnapshot& workpiece);
// Returns the zero of displayed Z values, mm above the lower end of the bar. In work on an exercise it is program zero,
// as in the task and the marks; otherwise it is the lower end itself.
double shownZero(const WorkpieceSnapshot& workpiece, bool isOfExercise);
// Returns the length of the bar beyond program zero; 0 without a target.
double programAllowance(const WorkpieceSnapshot& workpiece);

// Returns the properties of the position. They are the allowance, which can be changed and has a problem text if the
// target does not fit into the bar, the finished face, and the length left at the chuck's end.
std::vector<Property> positionProperties(const TargetProfile& target, const StockCylinder& stock);
// Returns a sentence that tells which end of the target is at the free end of the bar. The sentence names both ends by
// their diameters.
Note endsNote(const TargetProfile& target);
// Returns the target with another value of the allowance. Errors: ElementMalformed, ValueOutOfRange.
Result<TargetProfile> withPosition(const TargetProfile& target, const StockCylinder& stock, const PropertyValue& value);

}  // namespace handwheel
