// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/exercise/MarkingReport.h"

#include <array>

namespace handwheel {

// Returns the unit of a criterion as text.
std::string unitOf(const SubmissionsReport& report, const MarkingCriterion& criterion);
// The following texts are in the language of the program, unlike the output of the command line.
std::string pointsText(const Marking& marking);  // returns the points as "12 of 20 points"
std::string translatedText(const ExerciseText& text);
std::string translatedHeading(const std::string& heading);  // translates the heading of a table of marks, or the manner
                                                            // in which the work was made
std::string momentOf(const ReportEvent& event);  // returns the time as "0:05 min: "; empty: the event has no time
std::string localTime(
    const std::string& utc);  // converts to local time; a text that is not a time is returned unchanged
// Returns the marks of one student as cells: criterion, limits, measured, points, reason.
std::vector<std::array<std::string, 5>> rowsOf(const SubmissionsReport& report, const Marking& marking);

}  // namespace handwheel
