// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/measure/CrashTimes.h"

#include <algorithm>
#include <optional>

namespace handwheel {

namespace {

// A crash of a program is at a point of its path, one of the manual lathe is beside it.
std::optional<std::size_t> pointOfCrash(const TurningPass& pass, const LatheCollision& crash) {
  std::optional<std::size_t> nearest;
  double least = pass.tool ? kCrashReach : 0.0;
  for (std::size_t i = 0; i < std::min(pass.path.size(), pass.times.size()); ++i) {
    const double distance = (pass.path[i] - crash.position).norm();
    if (!(nearest ? distance < least : distance <= least)) continue;
    nearest = i;
    least = distance;
  }
  return nearest;
}

double secondsOf(const LatheCollision& crash, const TurningPasses& passes, const std::vector<double>& begins) {
  if (!(crash.passes >= 0.0)) return begins.back();
  const std::size_t count = passes.size();
  const auto had = static_cast<std::size_t>(std::min(crash.passes, static_cast<double>(count)));
  for (std::size_t pass = had == 0 ? 0 : had - 1; pass < std::min(had + 1, count); ++pass) {
    if (const auto point = pointOfCrash(*passes[pass], crash)) return begins[pass] + passes[pass]->times[*point];
  }
  return begins[had];
}

}  // namespace

std::vector<double> crashSeconds(const TurningPasses& passes, const std::vector<LatheCollision>& crashes) {
  std::vector<double> begins{0.0};
  for (const auto& pass : passes)
    begins.push_back(begins.back() + (pass->times.empty() ? 0.0 : std::max(0.0, pass->times.back())));
  std::vector<double> seconds;
  seconds.reserve(crashes.size());
  for (const LatheCollision& crash : crashes) seconds.push_back(secondsOf(crash, passes, begins));
  return seconds;
}

}  // namespace handwheel
