// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/CutLoads.h"
#include "document/workpiece/WorkpieceSnapshot.h"
#include "machining/PassesReplay.h"
#include "machining/measure/ProfileMeasure.h"

#include <optional>

namespace handwheel {

// The deviation of a part from its target while it is made, mm.
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
