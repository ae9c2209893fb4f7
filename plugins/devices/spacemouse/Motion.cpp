// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spacemouse/Motion.h"

#include <algorithm>

namespace handwheel::spacemouse {

namespace {

// Returns -1…1, turned by -90° about x: from z down to y up.
Vec3 share(const std::array<int, 3>& counts) {
  const auto axis = [&](std::size_t i) {
    return static_cast<double>(std::clamp(counts[i], -kFullScale, kFullScale)) / kFullScale;
  };
  return {axis(0), -axis(2), axis(1)};
}

}  // namespace

void setPose(const Counts& counts, DeviceState& state) {
  state.position = kTravel * share(counts.translation);
  const Vec3 turn = kFullTilt * share(counts.rotation);
  const double angle = turn.norm();
  state.orientation =
      angle > 0.0 ? Eigen::Quaterniond(Eigen::AngleAxisd(angle, turn / angle)) : Eigen::Quaterniond::Identity();
}

DeviceCapabilities capabilitiesWith(int buttons) {
  DeviceCapabilities all;
  all.inputs = 6;
  all.outputs = 0;
  all.buttons = buttons;
  all.workspaceRadius = kTravel;
  all.nominalRate = 62.5;
  all.latency = 0.016;
  all.isRateControl = true;
  return all;
}

}  // namespace handwheel::spacemouse
