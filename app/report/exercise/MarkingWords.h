// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/exercise/MarkingReport.h"

#include <array>

namespace handwheel {

// Texts that all forms of a marking report share.
std::string unitOf(const SubmissionsReport& report, const MarkingCriterion& criterion);
// The following texts are in the language of the program, unlike the output of the command line.
std::string pointsText(const Marking& marking);  // "12 of 20 points"
std::string translatedText(const ExerciseText& text);
std::string translatedHeading(
    const std::string& heading);  // heading of the table of a class, or the manner of production of the work
std::string momentOf(const ReportEvent& event);  // "0:05 min: "; empty: it has no time
std::string localTime(const std::string& utc);   // local time; other texts unchanged
// Returns the marks of one student as cells: criterion, limits, measured, points, reason.
std::vector<std::array<std::string, 5>> rowsOf(const SubmissionsReport& report, const Marking& marking);

}  // namespace handwheel
