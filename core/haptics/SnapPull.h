// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/SnapItem.h"

namespace handwheel {

// What snapping does to the hand at one tick.
struct SnapPull {
  static constexpr std::size_t kShown = 8;

  Vec3 force = Vec3::Zero();  // N, on the hand
  Vec3 proxy = Vec3::Zero();  // mm: the point to be shown; where nothing is held, the hand's own
  // N/mm, a bound of |dF/dx| here. It changes in steps as features come into reach: a scale of the force that follows
  // it has to be ramped.
  double slope = 0.0;
  double distance = 0.0;  // mm: the snap distance that held. Below the profile's where too many features were in reach
  bool isCutShort = false;  // the work of one tick was used up: what lies further may be missing
  // What acted, the strongest first, to be highlighted.
  std::array<SnapFeature, kShown> features = {};
  std::uint32_t featureCount = 0;
};

}  // namespace handwheel
