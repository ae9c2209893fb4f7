// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/servo/ServoStatistics.h"

#include <algorithm>
#include <limits>

namespace handwheel {

namespace {
constexpr double kFollowTime = 0.5;      // s
constexpr double kPeriodBins = 64.0;     // in a nominal period: four periods fit the histogram
constexpr double kDelayBin = 5e-6;       // s
constexpr double kAssumedPeriods = 2.0;  // until the loop has measured itself
}  // namespace

ServoStatistics::ServoStatistics(const DeviceCapabilities& device, double inherentDamping, double nominalPeriod)
    : m_device(device),
      m_inherentDamping(inherentDamping),
      m_nominalPeriod(nominalPeriod),
      m_usualPeriod(nominalPeriod / kPeriodBins, kAssumedPeriods * nominalPeriod),
      m_usualDelay(nominalPeriod / kPeriodBins, 0.0),
      m_periods(nominalPeriod / kPeriodBins),
      m_delays(kDelayBin),
      m_lateness(kDelayBin),
      m_limit(measuredLimit()) {}

void ServoStatistics::addPeriod(double seconds) {
  m_periods.add(seconds);
  m_usualPeriod.add(seconds);
  if (m_device.outputs == 0) return;
  m_limit += std::min(1.0, m_nominalPeriod / kFollowTime) * (measuredLimit() - m_limit);
}

void ServoStatistics::addDelay(double seconds) {
  m_delays.add(seconds);
  m_usualDelay.add(seconds);
}

void ServoStatistics::addLateness(double seconds) {
  m_lateness.add(seconds);
}

double ServoStatistics::measuredLimit() const {
  constexpr double kUnlimited = std::numeric_limits<double>::infinity();
  if (m_device.outputs == 0) return kUnlimited;
  const ServoTiming timing{m_usualPeriod.value(), m_device.latency + m_usualDelay.value(), m_inherentDamping};
  return std::min(handwheel::stiffnessLimit(timing, 0.0),
                  m_device.maxStiffness > 0.0 ? m_device.maxStiffness : kUnlimited);
}

}  // namespace handwheel
