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
  // A bound of |dF/dx| here, N/mm. It changes in steps as features come into reach: a scale of the force that follows
  // it has to be ramped.
  double slope = 0.0;
  double distance = 0.0;    // mm: the snap distance applied. Below the profile's if too many features were in reach
  bool isCutShort = false;  // the work limit of a tick was reached: features further away may be missing
  // The features that acted, the strongest first, to be highlighted.
  std::array<SnapFeature, kShown> features = {};
  std::uint32_t featureCount = 0;
};

}  // namespace handwheel
