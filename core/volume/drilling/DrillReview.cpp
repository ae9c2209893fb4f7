// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillReview.h"

namespace handwheel {
namespace {

std::optional<double> meanThrustBefore(const std::vector<DrillMoment>& moments, double breakthrough) {
  std::size_t end = 0;
  while (end < moments.size() && moments[end].time < breakthrough) ++end;
  if (end == moments.size()) return std::nullopt;
  double impulse = 0.0, seconds = 0.0;
  for (std::size_t i = end; i > 0 && moments[end].depth - moments[i].depth < DrillReview::kEndOfBone; --i) {
    const double dt = moments[i].time - moments[i - 1].time;
    impulse += moments[i].thrust * dt;
    seconds += dt;
  }
  return seconds > 0.0 ? std::optional(impulse / seconds) : std::nullopt;
}

}  // namespace

std::optional<DrillReview> reviewDrilling(SparseVolume stock, const DrillPlan& plan,
                                          std::span<const std::shared_ptr<const DrillRecord>> holes,
                                          Progress progress) {
  constexpr std::size_t kBetweenLooks = 256;
  DrillReview review;
  review.left = std::move(stock);
  DrillMonitor watch(plan);
  std::size_t poses = 0;
  for (const auto& hole : holes) poses += hole->poses.size();
  for (const auto& hole : holes) {
    DrillRun run(review.left, hole->setup);
    watch.beginHole(hole->setup);
    for (std::size_t i = 0; i < hole->poses.size(); ++i) {
      const std::size_t done = review.moments.size();
      if (progress.cancelled()) return std::nullopt;
      if (done % kBetweenLooks == 0) progress.set(static_cast<double>(done) / static_cast<double>(poses));
      const DrillPose& pose = hole->poses[i];
      const DrillTick tick = move(run, pose);
      review.moments.push_back(watch.add(tick, pose.direction(), run.breakthrough().has_value()));
    }
  }
  review.figures = watch.figures();
  if (review.figures.breakthrough) review.lastThrust = meanThrustBefore(review.moments, *review.figures.breakthrough);
  return review;
}

}  // namespace handwheel
