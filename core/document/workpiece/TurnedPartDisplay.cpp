// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/TurnedPartDisplay.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

DisplayModel displayOf(const TurnedSurface& surface, double base) {
  DisplayModel model;
  for (std::size_t b = 0; b < surface.blocks().size(); ++b) {
    DisplayPart part;
    part.name = "block." + std::to_string(b);
    part.group = kStockGroup;
    part.soup = surface.blocks()[b];
    part.pose.translation().z() = base;
    model.parts.push_back(std::move(part));
  }
  return model;
}

void showFinish(DisplayModel& model, const TurnedProfile& profile, const SurfaceFinish& finish) {
  constexpr std::array<float, 3> kDull{0.50f, 0.51f, 0.53f}, kBright{0.93f, 0.95f, 0.98f};
  constexpr double kRough = 12.5, kPolished = 0.2;  // µm
  constexpr std::size_t kBlock = TurnedSurface::kBlockSamples;
  for (std::size_t b = 0; b < model.parts.size(); ++b) {
    const auto ra = finish.mean(profile, TurningSide::Outside, {b * kBlock, (b + 1) * kBlock});
    if (!ra) continue;
    const double share = std::log(kRough / std::max(*ra, kPolished)) / std::log(kRough / kPolished);
    const auto gloss = static_cast<float>(std::clamp(share, 0.0, 1.0));
    for (std::size_t c = 0; c < 3; ++c) model.parts[b].colour[c] = kDull[c] + gloss * (kBright[c] - kDull[c]);
  }
}

}  // namespace handwheel
