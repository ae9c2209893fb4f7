// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Device.h"
#include "haptics/VelocityEstimator.h"

namespace handwheel {

// What the readings of a device tell of the hand's motion, where the loop may ask more often than the device answers.
// Servo thread; allocates nothing.
class HandMotion {
 public:
  struct Periods {  // s
    double loop = 0.001;
    double device = 0.001;  // from one of its readings to the next
    double stale = 0.005;   // so long the last one counts
  };
  HandMotion(double velocityWindow, const Periods& periods) : m_estimator(velocityWindow), m_periods(periods) {}

  struct Seen {
    Vec3 velocity = Vec3::Zero();  // mm/s, as the device says, or estimated from new readings; zero when they are stale
    // mm/s: the way from the last reading to this one by the time between them, which is that of the loop, but never
    // less than the device takes for so many readings: packets that come in a bunch are no faster hand. 0: nothing new.
    double stepSpeed = 0.0;
    bool isNew = true;
  };
  // A reading with finite numbers, so many seconds (> 0) after the one before.
  Seen add(const DeviceState& state, double period);
  void reset();

 private:
  double stepSpeed(const DeviceState& state) const;

  VelocityEstimator m_estimator;
  Periods m_periods;
  Vec3 m_position = Vec3::Zero();  // of the last new one,
  Vec3 m_velocity = Vec3::Zero();
  std::uint32_t m_number = 0;
  double m_time = 0.0;  // s since then
  bool m_hasReading = false;
};

}  // namespace handwheel
