// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/exercise/MarkingReport.h"

#include <array>

namespace handwheel {

// What the forms of a report have in common.
std::string unitOf(const ClassReport& report, const MarkingCriterion& criterion);
std::string pointsText(const Marking& marking);  // "12 of 20 points"
// The marks of one student as cells: criterion, limits, measured, points, reason.
std::vector<std::array<std::string, 5>> rowsOf(const ClassReport& report, const Marking& marking);

}  // namespace handwheel
