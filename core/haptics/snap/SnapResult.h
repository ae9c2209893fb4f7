// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/snap/SnapItem.h"

namespace handwheel {

// Result of snapping for one tick: force, proxy and acting features.
struct SnapResult {
  static constexpr std::size_t kShown = 8;

  Vec3 force = Vec3::Zero();  // N, on the tip
  Vec3 proxy = Vec3::Zero();  // mm: the point to be displayed; the tip where nothing is held
  // N/mm, a bound of |dF/dx| here. It changes in steps as features come into reach: a scale of the force that follows
  // it has to be ramped.
  double slope = 0.0;
  double distance = 0.0;  // mm: the snap distance that held. Below the profile's where too many features were in reach
  bool isCutShort = false;  // the work of one tick was used up: what lies further may be missing
  // The features that acted, the strongest first, to be highlighted.
  std::array<SnapFeature, kShown> features = {};
  std::uint32_t featureCount = 0;
};

}  // namespace handwheel
