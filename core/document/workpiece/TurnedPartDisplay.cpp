// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/TurnedPartDisplay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace handwheel {

namespace {

constexpr std::array<float, 3> kDull{0.50f, 0.51f, 0.53f}, kBright{0.88f, 0.90f, 0.93f};
constexpr float kMostGloss = 0.7f;

// 0: as rough as N10, 1: as fine as N4. None: nothing is known of these samples.
std::optional<float> meanGloss(const TurnedProfile& profile, const SurfaceFinish& finish,
                               const TurnedProfile::Range& samples) {
  constexpr float kRough = 12.5f, kPolished = 0.2f;  // µm
  constexpr std::size_t kStride = 8;                 // it is asked for each frame
  const float whole = std::log(kRough / kPolished);
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = samples.first; i < samples.last; i += kStride) {
    const FinishMark mark = finish.at(TurningSide::Outside, i);
    if (!mark.isKnown() || !profile.hasMaterial(i)) continue;
    sum += std::log(kRough / std::clamp(mark.roughness, kPolished, kRough)) / whole;
    ++count;
  }
  return count > 0 ? std::optional(static_cast<float>(sum / count)) : std::nullopt;
}

}  // namespace

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
  constexpr std::size_t kBlock = TurnedSurface::kBlockSamples;
  for (std::size_t b = 0; b < model.parts.size(); ++b) {
    const auto share = meanGloss(profile, finish, {b * kBlock, std::min((b + 1) * kBlock, profile.size())});
    if (!share) continue;
    DisplayPart& part = model.parts[b];
    part.gloss = std::lerp(0.0f, kMostGloss, *share);
    for (std::size_t c = 0; c < 3; ++c) part.colour[c] = std::lerp(kDull[c], kBright[c], *share);
  }
}

}  // namespace handwheel
