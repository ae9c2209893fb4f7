// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/exercise/DrillingTask.h"
#include "volume/drilling/DrillReview.h"

namespace handwheel {

// Thrust or torque over time with its reference curve, and the breakthrough as a line. The reference is (3-22) or
// (3-23) at the same feed. The constants of the reference are those with which both agree on a ball that drills deep
// inside: Ks = kp / (2 ktc), Ru = kp / 5; so it is their shapes that are compared.
ReportCurve thrustCurve(const DrillSetup& setup, const std::vector<DrillMoment>& moments);
ReportCurve torqueCurve(const DrillSetup& setup, const std::vector<DrillMoment>& moments);
// Depth of the tip along the plan, and how far it is beside it.
ReportCurve depthCurve(const std::vector<DrillMoment>& moments);
ReportCurve heatCurve(const std::vector<DrillMoment>& moments);

// What a report shows of drilling besides the marks: the hole in section, the peaks, the curves, the breakthrough, and
// what went wrong. holes, review: of the same work.
ReportDetails drillingDetails(const DrillingTask& task, const DrilledHoles& holes, const DrillReview& review,
                              Progress progress = {});

// Adds how many tries the work took, and each that was in the forbidden region before it was taken back.
void addTries(ReportDetails& details, const DrillTries& tries);

}  // namespace handwheel
