// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/safety/SafetySettings.h"

namespace handwheel {

// Damps fast motion of the tip, and cuts the force at excessive speed. That is, faster than normal hand motion, or as
// fast as a handle that was let go. There is no damping below.
class SpeedLimit {
 public:
  explicit SpeedLimit(const SafetySettings& settings) : m_settings(settings) {}

  // The damping force, N, for a velocity in mm/s: nothing up to dampingSpeed, then a coefficient that grows in
  // proportion to the excess up to speedDamping at cutSpeed.
  Vec3 damping(const Vec3& velocity) const;
  // Whether no force may be sent: from cutSpeed (mm/s) on until the tip is slower than dampingSpeed again.
  bool cuts(double speed);

 private:
  SafetySettings m_settings;
  bool m_isCut = false;
};

}  // namespace handwheel
