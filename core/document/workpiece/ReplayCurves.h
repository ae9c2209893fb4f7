// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceSnapshot.h"
#include "machining/PassesReplay.h"
#include "machining/force/WorkMaterials.h"
#include "machining/measure/ProfileMeasure.h"
#include "machining/measure/TurningReview.h"

#include <optional>

namespace handwheel {

// Force and power of a cut by Kienzle's law, with the edge of its tool. The constants of this law differ by a quarter
// between sources. The force is the resultant of the three components, as the panel of the manual lathe shows it and
// `turn` reports it. The power is that of the motor at the set speed, like the power limit of a lathe; an overloaded
// motor slows down and gives less than the cut needs.
struct CutLoad {
  double time = 0.0;   // s, as in TurningReview
  double force = 0.0;  // N, resultant
  double power = 0.0;  // kW, at the motor
};
// Returns the loads at each moment of a review of passes. What is abrasive cuts no chip and has no load. wear: flank
// wear of the tools, mm.
std::vector<CutLoad> cutLoads(const TurningReview& review, TurningReview::Passes passes, const WorkMaterial& material,
                              double wear = 0.0);

// The deviation of a part from its target over the time in which the part is made, mm.
struct DeviationTrack {
  using Curve = std::vector<std::pair<double, double>>;  // (s, mm)
  Curve left;                                            // largest remaining material over the target
  Curve deep;                                            // largest depth cut below the target
};
// Computes the deviation at `count` moments of a replay. base: z of the part's lower end in the coordinates of the
// target, mm; range: the z range of the part to compare, mm. The result is incomplete if cancelled. O(count · samples
// of the part · log(segments of the target)).
DeviationTrack deviationTrack(const PassesReplay& replay, const TargetProfile& target, double base, AxisRange range,
                              int count, Progress progress = {});

// Curves of the making of a part, over the time of its replay.
struct ReplayCurves {
  struct Crash {
    double seconds = 0.0;  // end of its pass if the exact time is unknown
    LatheCollision collision;
  };
  std::shared_ptr<const PassesReplay> replay;
  std::vector<CutLoad> loads;
  std::optional<DeviationTrack> deviation;  // none without a target
  std::vector<Crash> crashes;               // in order of time
};
// Returns the curves of a cut workpiece. Returns nothing if cancelled. The cost is proportional to all that the passes
// cut.
std::optional<ReplayCurves> replayCurves(const WorkpieceSnapshot& workpiece, Progress progress = {});

}  // namespace handwheel
