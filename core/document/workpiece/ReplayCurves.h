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

// Force and power of a cut by Kienzle's law, with a sharp edge. The sources of that law differ by a quarter. The power
// is that of the motor at the set speed, as the limit of a lathe is; an overloaded motor slows down and gives less than
// the cut needs.
struct CutLoad {
  double time = 0.0;   // s, as in TurningReview
  double force = 0.0;  // N
  double power = 0.0;  // kW
};
std::vector<CutLoad> cutLoads(const TurningReview& review, const WorkMaterial& material);

// The deviation of a part from its target while it is made, mm.
struct DeviationTrack {
  using Curve = std::vector<std::pair<double, double>>;  // (s, mm)
  Curve left;                                            // largest remaining material over the target
  Curve deep;                                            // largest depth cut below the target
};
// Samples the replay at `count` moments. base: mm, z of the part's lower end in the coordinates of the target; range:
// range of the part. Incomplete when cancelled. O(count · samples · log segments).
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
  std::vector<Crash> crashes;               // by time
};
// Returns the curves of a cut workpiece. None: cancelled. O(all that the passes cut).
std::optional<ReplayCurves> replayCurves(const WorkpieceSnapshot& workpiece, Progress progress = {});

}  // namespace handwheel
