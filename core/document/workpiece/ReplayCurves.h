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
// is that of the motor, as the limit of a lathe is, at the speed that the levers ask for: a motor that is overloaded
// slows down and gives less than the cut needs.
struct CutLoad {
  double time = 0.0;   // s, as in TurningReview
  double force = 0.0;  // N
  double power = 0.0;  // kW
};
std::vector<CutLoad> cutLoads(const TurningReview& review, const WorkMaterial& material);

// How far a part is from its target while it is made, mm.
struct DeviationTrack {
  using Curve = std::vector<std::pair<double, double>>;  // (s, mm)
  Curve left;                                            // material that is still over the target, at most
  Curve deep;                                            // too much that was cut, at most
};
// At `count` moments of the replay. base: mm, z of the part's lower end in the coordinates of the target; range: of the
// part. Incomplete when cancelled. O(count · samples · log segments).
DeviationTrack deviationTrack(const PassesReplay& replay, const TargetProfile& target, double base, AxisRange range,
                              int count, Progress progress = {});

// How a part was made, over the time of its replay.
struct ReplayCurves {
  struct Crash {
    double seconds = 0.0;  // where it is not known exactly, the end of its pass
    LatheCollision collision;
  };
  std::shared_ptr<const PassesReplay> replay;
  std::vector<CutLoad> loads;
  std::optional<DeviationTrack> deviation;  // none without a target
  std::vector<Crash> crashes;               // by time
};
// The curves of a workpiece that was cut. None: cancelled. O(all that the passes cut).
std::optional<ReplayCurves> replayCurves(const WorkpieceSnapshot& workpiece, Progress progress = {});

}  // namespace handwheel
