// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"
#include "haptics/device/VelocityEstimator.h"

namespace handwheel {

// Computes the velocity and speed of a device from its readings. The loop may poll more often than the device delivers
// readings. The estimator is used on the servo thread, and does not allocate.
class DeviceMotionEstimator {
 public:
  // Periods of the loop and the device, s.
  struct Periods {
    double loop = 0.001;
    double device = 0.001;  // time from one reading of the device to the next
    double stale = 0.005;   // time for which a reading is valid
  };
  DeviceMotionEstimator(double velocityWindow, const Periods& periods)
      : m_estimator(velocityWindow), m_periods(periods) {}

  // Result for one reading.
  struct Seen {
    // Velocity from the device or estimated from new readings, mm/s. It is zero when the readings are stale.
    Vec3 velocity = Vec3::Zero();
    // Distance from the last reading to this one divided by the time between them, mm/s. The time is that of the loop,
    // but at least the time that the device needs for this number of readings: packets that arrive in a burst are not a
    // faster motion. 0: the reading is not new.
    double stepSpeed = 0.0;
    bool isNew = true;
  };
  // Adds a reading with finite numbers, `period` seconds (> 0) after the previous one.
  Seen add(const DeviceState& state, double period);
  void reset();

 private:
  double stepSpeed(const DeviceState& state) const;

  VelocityEstimator m_estimator;
  Periods m_periods;
  Vec3 m_position = Vec3::Zero();  // position and velocity of the last new reading
  Vec3 m_velocity = Vec3::Zero();
  std::uint32_t m_number = 0;
  double m_time = 0.0;  // s since the last new reading
  bool m_hasReading = false;
};

}  // namespace handwheel
