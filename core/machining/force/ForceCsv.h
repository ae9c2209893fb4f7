// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/force/ForceSamples.h"

#include <string_view>

namespace handwheel {

// Reads a table of measured cuts as comma-separated values with a header line (RFC 4180). The text is not trusted.
// Columns are found by their names, in any order. A name in exact case is preferred to one in another case:
//   depth of cut, mm: ap, depth or a; or an area in mm², A_cal or A0, which is divided by the feed
//   feed, mm per revolution: f_cal (measured), f or feed
//   cutting speed, m/min: vc, v or speed; or a spindle speed rpm, from which the diameter gives it
//   cutting force, N: Fc; without it Fx if there is a column ap, otherwise Fz
//   wear, mm: TCond or VB
// If a table has several columns for a quantity, the one named first here counts. Rows of a worn tool, and rows in
// which one of these values is missing or "na", are counted and left out. Rows with the same cut and force count as
// one sample. diameter: mm, diameter of the work; 0: not known.
// Errors with the line: ColumnMissing, ColumnTwice, DiameterNeeded, NumberMalformed, NumberNotFinite, ValueOutOfRange
// {"the value", value, least, largest}. Errors without it: FileTooLarge {"rows", "", limit}, FileEmpty, Cancelled.
// O(length).
Result<ForceSamples> forceSamplesFromCsv(std::string_view text, double diameter = 0.0, Progress progress = {});
inline constexpr std::size_t kMostForceRows = 200'000, kMostForceColumns = 1'000;

}  // namespace handwheel
