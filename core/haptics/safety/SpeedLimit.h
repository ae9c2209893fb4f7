// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/safety/SafetySettings.h"

namespace handwheel {

// Damps fast motion of the tip, and cuts the force at excessive speed. The damping applies to motion faster than that
// of a hand, the cut to the speed of a handle that was let go.
class SpeedLimit {
 public:
  explicit SpeedLimit(const SafetySettings& settings) : m_settings(settings) {}

  // Returns the damping force, N, for a velocity in mm/s. The force is zero up to dampingSpeed. Above it, the damping
  // coefficient grows in proportion to the excess, up to speedDamping at cutSpeed.
  Vec3 damping(const Vec3& velocity) const;
  // Returns true if no force may be sent. This is so from cutSpeed (mm/s) on, until the tip is slower than dampingSpeed
  // again.
  bool cuts(double speed);

 private:
  SafetySettings m_settings;
  bool m_isCut = false;
};

}  // namespace handwheel
