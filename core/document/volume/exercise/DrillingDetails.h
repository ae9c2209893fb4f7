// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/exercise/DrillingTask.h"
#include "volume/drilling/DrillReview.h"

namespace handwheel {

// Returns thrust or torque over time with a reference curve and the breakthrough. The reference is He 2008, eq. 3-22
// for thrust and 3-23 for torque, at the same feed. Its constants (agreeingReference()) are those for which both curves
// agree for a spherical head entirely in the material, so the comparison concerns only the shapes of the curves.
ReportCurve thrustCurve(const DrillSetup& setup, const std::vector<DrillMoment>& moments);
ReportCurve torqueCurve(const DrillSetup& setup, const std::vector<DrillMoment>& moments);
// Returns the depth of the tip along the planned path and its deviation from the path, over time.
ReportCurve depthCurve(const std::vector<DrillMoment>& moments);
ReportCurve heatCurve(const std::vector<DrillMoment>& moments);

// Returns the details of a report in addition to the marks: the section of the hole, the peaks, the curves, the
// breakthrough, and the faults. holes, review: the holes and the review of the same work.
ReportDetails drillingDetails(const DrillingTask& task, const DrilledHoles& holes, const DrillReview& review,
                              Progress progress = {});

// Adds the number of tries, and each try in the forbidden region that was undone.
void addTries(ReportDetails& details, const DrillTries& tries);

}  // namespace handwheel
