// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Device.h"
#include "haptics/StiffnessLimit.h"
#include "haptics/TimingHistogram.h"
#include "haptics/UsualTime.h"

namespace handwheel {

// What the loop measures of itself while it runs, and the stiffness that follows from it. The servo thread adds; the
// histograms may be read from any thread.
class LoopMeasure {
 public:
  LoopMeasure(const DeviceCapabilities& device, double inherentDamping, double nominalPeriod);

  void addPeriod(double seconds);    // from tick to tick
  void addDelay(double seconds);     // from reading the device to writing it
  void addLateness(double seconds);  // from when a tick was due to when it came

  // N/mm at the device, without virtual damping: follows what was measured within half a second, so that no step is
  // felt. Never more than its maker states; without a limit for a device that has no motors.
  double stiffnessLimit() const { return m_limit; }

  double nominalPeriod() const { return m_nominalPeriod; }  // s
  const TimingHistogram& periods() const { return m_periods; }
  const TimingHistogram& delays() const { return m_delays; }
  const TimingHistogram& lateness() const { return m_lateness; }

 private:
  double measuredLimit() const;

  DeviceCapabilities m_device;
  double m_inherentDamping;
  double m_nominalPeriod;
  UsualTime m_usualPeriod;
  UsualTime m_usualDelay;
  TimingHistogram m_periods;
  TimingHistogram m_delays;
  TimingHistogram m_lateness;
  double m_limit;
};

}  // namespace handwheel
