// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/exercise/MarkingReport.h"

#include <array>

namespace handwheel {

// Texts that all forms of a marking report share.
std::string unitOf(const SubmissionsReport& report, const MarkingCriterion& criterion);
// These are in the language of the program, which that of the command line is not.
std::string pointsText(const Marking& marking);  // "12 of 20 points"
std::string translatedText(const ExerciseText& text);
std::string translatedHeading(const std::string& heading);  // of the table of a class, or how work was made
std::string momentOf(const ReportEvent& event);             // "0:05 min: "; empty: it has no time
std::string localTime(const std::string& utc);              // of the clock on the wall; what is no time as it is
// The marks of one student as cells: criterion, limits, measured, points, reason.
std::vector<std::array<std::string, 5>> rowsOf(const SubmissionsReport& report, const Marking& marking);

}  // namespace handwheel
