// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Device.h"

#include <array>

namespace handwheel::spacemouse {

// The cap's displacement from rest as HID reports count it: X right, Y towards the user, Z down (right-handed), and the
// rotation vector about the same axes. Full scale is 350; devices are seen to go beyond.
struct Counts {
  std::array<int, 3> translation{};
  std::array<int, 3> rotation{};

  bool isZero() const { return translation == std::array<int, 3>{} && rotation == std::array<int, 3>{}; }
  bool operator==(const Counts&) const = default;
};

inline constexpr int kFullScale = 350;
inline constexpr double kTravel = 1.4;    // mm at full scale, as the report descriptors say (1400 times 1e-4 cm)
inline constexpr double kFullTilt = 1.0;  // rad at full scale; by convention, the descriptors give no angle

// Position and orientation in the frame of Device.h: x right, y up, z towards the user. Each axis is clamped to full
// scale.
void place(const Counts& counts, DeviceState& state);

// The data sheet that all share.
DeviceCapabilities capabilitiesWith(int buttons);

}  // namespace handwheel::spacemouse
