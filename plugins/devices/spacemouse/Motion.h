// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

#include <array>

namespace handwheel::spacemouse {

// The cap's displacement from rest, in the units of HID reports. X is to the right, Y towards the user and Z down
// (right-handed); the rotation vector refers to the same axes. Full scale is 350; devices are known to exceed it.
struct Counts {
  std::array<int, 3> translation{};
  std::array<int, 3> rotation{};

  bool isZero() const { return translation == std::array<int, 3>{} && rotation == std::array<int, 3>{}; }
  bool operator==(const Counts&) const = default;
};

inline constexpr int kFullScale = 350;
inline constexpr double kTravel = 1.4;    // mm at full scale, from the report descriptors (1400 times 1e-4 cm)
inline constexpr double kFullTilt = 1.0;  // rad at full scale; a convention, because the descriptors state no angle

// Sets position and orientation from counts. They are in the frame of Device.h: x right, y up, z towards the user. Each
// axis is clamped to full scale.
void setPose(const Counts& counts, DeviceState& state);

// Returns the capabilities that all models share.
DeviceCapabilities capabilitiesWith(int buttons);

}  // namespace handwheel::spacemouse
