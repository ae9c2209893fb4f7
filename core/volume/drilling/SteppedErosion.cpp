// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/SteppedErosion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace handwheel {

namespace {

constexpr double kLevels = 255.0;  // s, of the density of a voxel

}  // namespace

bool isDrillable(const SteppedHole& hole) {
  for (const double number : {hole.diameter, hole.voxel, hole.feed, hole.step, hole.rate, hole.thickness})
    if (!(number > 0.0) || !std::isfinite(number)) return false;
  constexpr double kMost = 1e8;
  const double across = hole.diameter / hole.voxel + 2.0;
  return hole.step <= kLevels && across * across * (hole.thickness / hole.voxel + 1.0) < kMost &&
         (hole.diameter + hole.thickness) / hole.feed * hole.rate < kMost;
}

std::vector<double> removedBySteps(const SteppedHole& hole) {
  if (!isDrillable(hole)) return {};
  const double radius = 0.5 * hole.diameter, travel = hole.feed / hole.rate;  // mm; Δd
  const auto cycles = static_cast<std::size_t>(std::ceil((hole.diameter + hole.thickness) / travel)) + 1;
  const double life = std::ceil(kLevels / hole.step);  // cycles until nothing of a voxel is left
  const double last = kLevels - (life - 1.0) * hole.step;
  // Change of the loss of all voxels from cycle to cycle, in levels.
  std::vector<double> change(cycles + 2, 0.0);
  const auto add = [&](double cycle, double levels) {
    change[static_cast<std::size_t>(std::clamp(cycle, 0.0, static_cast<double>(cycles + 1)))] += levels;
  };
  const int most = static_cast<int>(radius / hole.voxel) + 1;
  const int layers = std::max(1, static_cast<int>(std::lround(hole.thickness / hole.voxel)));
  for (int j = -most; j < most; ++j)
    for (int i = -most; i < most; ++i) {
      const double x = (i + 0.5) * hole.voxel, y = (j + 0.5) * hole.voxel, square = radius * radius - x * x - y * y;
      if (!(square > 0.0)) continue;
      const double half = std::sqrt(square);  // half chord of the ball at the voxel
      for (int k = 0; k < layers; ++k) {
        // The ball's centre is above the plate by its radius at first.
        const double below = radius + (k + 0.5) * hole.voxel;
        const double begin = std::ceil((below - half) / travel), leave = std::ceil((below + half) / travel);
        const double end = std::min(begin + life, leave);
        add(begin, hole.step);
        add(end, -hole.step);
        // The last step removes the rest.
        if (end < begin + life) continue;
        add(end - 1.0, last - hole.step);
        add(end, hole.step - last);
      }
    }
  std::vector<double> removed;
  double levels = 0.0;
  const double volume = hole.voxel * hole.voxel * hole.voxel / kLevels;
  for (std::size_t cycle = 0; cycle < cycles; ++cycle) {
    levels += change[cycle];
    removed.push_back(std::max(0.0, levels) * volume);
  }
  return removed;
}

}  // namespace handwheel
