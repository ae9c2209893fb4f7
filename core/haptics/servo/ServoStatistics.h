// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"
#include "haptics/safety/StiffnessLimit.h"
#include "haptics/servo/PeriodQuantile.h"
#include "haptics/servo/TimingHistogram.h"

namespace handwheel {

// Timing statistics of the servo loop, and the stiffness limit derived from them. The servo thread adds values; the
// histograms may be read on any thread.
class ServoStatistics {
 public:
  ServoStatistics(const DeviceCapabilities& device, double inherentDamping, double nominalPeriod);

  void addPeriod(double seconds);    // time from tick to tick
  void addDelay(double seconds);     // time from reading the device to writing it
  void addLateness(double seconds);  // time from the due time of a tick to its start

  // Returns the stiffness limit at the device, N/mm, without virtual damping. It follows the measurements within half a
  // second, so that no jump is felt. It never exceeds the stiffness that the manufacturer states. A device without
  // motors has no limit.
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
  PeriodQuantile m_usualPeriod;
  PeriodQuantile m_usualDelay;
  TimingHistogram m_periods;
  TimingHistogram m_delays;
  TimingHistogram m_lateness;
  double m_limit;
};

}  // namespace handwheel
