// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceSnapshot.h"
#include "machining/force/WorkMaterials.h"
#include "machining/measure/TurningReview.h"

#include <optional>

namespace handwheel {

// Force and power of a cut by Kienzle's law, with the edge of its tool. The constants of this law differ by a quarter
// between sources. The force is the resultant of the three components, as the panel of the manual lathe shows it and
// `turn` reports it. The power is that of the motor at the set speed, like the power limit of a lathe; an overloaded
// motor slows down and gives less than the cut needs.
struct CutLoad {
  double time = 0.0;                  // s, as in TurningReview
  double force = 0.0;                 // N, resultant
  double power = 0.0;                 // kW, at the motor
  double thrust = 0.0, torque = 0.0;  // N, N·m, of a drill
  double drill = 0.0;                 // mm, diameter of the drill; 0: another tool
};
// Returns the loads at each moment of a review of passes. What is abrasive cuts no chip and has no load. wear: flank
// wear of the tools, mm.
std::vector<CutLoad> cutLoads(const TurningReview& review, TurningReview::Passes passes, const WorkMaterial& material,
                              double wear = 0.0);

// The largest loads of drills.
struct DrillPeaks {
  double diameter = 0.0;  // mm, of the drill with the largest torque; 0: nothing was drilled
  double thrust = 0.0;    // N
  double torque = 0.0;    // N·m
  double power = 0.0;     // kW, at the cut
};

// The largest loads of cuts.
struct LoadPeaks {
  double force = 0.0;  // N, resultant
  double power = 0.0;  // kW, at the motor
  DrillPeaks drilling;
};
// Returns the peaks of the passes of a workpiece after the passes of `before`, which must be an earlier part of it; if
// it is null, all passes count. Returns nothing if the review takes too much work or is cancelled.
std::optional<LoadPeaks> loadPeaks(const WorkpieceSnapshot& workpiece, const TurnedPart* before,
                                   const WorkMaterial& material, const ReviewedLathe& lathe, Progress progress = {});

}  // namespace handwheel
