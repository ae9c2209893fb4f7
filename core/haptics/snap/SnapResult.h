// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/snap/SnapItem.h"

namespace handwheel {

// Result of snapping for one tick: force, proxy and acting features.
struct SnapResult {
  static constexpr std::size_t kShown = 8;

  Vec3 force = Vec3::Zero();  // N, on the tip
  Vec3 proxy = Vec3::Zero();  // mm, displayed position; that of the tip if nothing is held
  // An upper bound of |dF/dx| at the tip, N/mm. It jumps when features come into reach, so a scale of the force that is
  // derived from it has to be ramped.
  double slope = 0.0;
  double distance = 0.0;    // mm, snap distance used; reduced if too many features are in reach
  bool isCutShort = false;  // the work limit of a tick was reached: features further away may be missing
  // The features that acted, the strongest first, to be highlighted.
  std::array<SnapFeature, kShown> features = {};
  std::uint32_t featureCount = 0;
};

}  // namespace handwheel
