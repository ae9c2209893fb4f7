// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/ReplayCurves.h"

#include "document/workpiece/LatheSetupEdit.h"
#include "machining/measure/CrashTimes.h"
#include "machining/target/TargetDeviation.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr int kDeviations = 60;  // moments at which the deviation is measured

}  // namespace

DeviationTrack deviationTrack(const PassesReplay& replay, const TargetProfile& target, double base, AxisRange range,
                              int count, Progress progress) {
  DeviationTrack track;
  for (int i = 0; i < count && !progress.cancelled(); ++i) {
    const double seconds = replay.duration() * i / std::max(count - 1, 1);
    const TargetDeviation deviation = deviationFrom(target, replay.at(seconds).profile, base, {}, range);
    track.left.emplace_back(seconds, deviation.largestOver.distance);
    track.deep.emplace_back(seconds, -deviation.largestUnder.distance);
    progress.set(static_cast<double>(i + 1) / count);
  }
  return track;
}

std::optional<ReplayCurves> replayCurves(const WorkpieceSnapshot& workpiece, Progress progress) {
  const TurnedPart& part = *workpiece.part;
  const TurnedProfile bar = TurnedProfile::barOf(workpiece.stock, part.profile.size());
  auto replay = PassesReplay::make(bar, part.passes, progress.part(0.0, 0.3));
  if (!replay) return std::nullopt;
  ReplayCurves track;
  track.replay = std::make_shared<const PassesReplay>(std::move(*replay));
  std::vector<TurningPasses::Pass> passes;
  for (const auto& pass : part.passes) passes.push_back(pass);
  const LatheSetup lathe = latheOf(workpiece);
  ReviewedLathe reviewed;
  reviewed.spindleSpeed = lathe.spindle.speed;
  const auto review = TurningReview::make(bar, passes, reviewed, progress.part(0.3, 0.7));
  const WorkMaterials& materials = WorkMaterials::standard();
  if (review) track.loads = cutLoads(*review, passes, materials.called(workpiece.material), lathe.wear);
  if (workpiece.target) {
    const TargetProfile& target = workpiece.target->profile;
    const double base = workpiece.stock.position;
    track.deviation = deviationTrack(*track.replay, target, base, rangeOfTarget(target, bar, base, lathe.chuck.grip),
                                     kDeviations, progress.part(0.7, 1.0));
  }
  if (workpiece.crashes) {
    const std::vector<double> seconds = crashSeconds(part.passes, *workpiece.crashes);
    for (std::size_t i = 0; i < seconds.size(); ++i) track.crashes.push_back({seconds[i], (*workpiece.crashes)[i]});
  }
  std::stable_sort(track.crashes.begin(), track.crashes.end(),
                   [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
  if (progress.cancelled()) return std::nullopt;
  return track;
}

}  // namespace handwheel
