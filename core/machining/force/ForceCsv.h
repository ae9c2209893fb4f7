// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/force/ForceSamples.h"

#include <string_view>

namespace handwheel {

// Reads a table of measured cuts as comma-separated values with a header line (RFC 4180). Its origin is untrusted.
// Columns are found by name, in any order; exact case first, then any case:
//   depth of cut, mm: ap, depth, a, A_cal or A0 (these two are areas in mm², divided by the feed)
//   feed, mm per revolution: f_cal (measured) before f or feed
//   cutting speed, m/min: vc, v or speed; else rpm with the diameter
//   cutting force, N: Fc; else of Fx, Fy, Fz: Fx if there is a column ap, else Fz
//   wear, mm: TCond, VB
// Rows of a worn tool, and those with "na" in such a column, are counted and left out. Rows with the same cut and force
// are one sample.
// diameter: mm, diameter of the work; 0: not known.
// Errors, with the line: ColumnMissing, ColumnTwice, DiameterNeeded, DataTruncated {columns, expected, found},
// NumberMalformed, NumberNotFinite, ValueOutOfRange {column, value, least, largest}, FileTooLarge {rows}, FileEmpty,
// Cancelled. O(length).
Result<ForceSamples> forceSamplesFromCsv(std::string_view text, double diameter = 0.0, Progress progress = {});
inline constexpr std::size_t kMostForceRows = 200'000, kMostForceColumns = 1'000;

}  // namespace handwheel
