// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/LatheWarnings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr double kKilowatt = 60'000.0 / (2.0 * M_PI);  // N·m times r/min in a kW

}  // namespace

SpindleDrive driveOf(const LatheSpindle& spindle) {
  constexpr double kUnlimited = std::numeric_limits<double>::infinity();
  SpindleDrive drive;
  drive.power = spindle.power > 0.0 ? spindle.power : kUnlimited;
  drive.torque = spindle.torque > 0.0 ? spindle.torque : kUnlimited;
  return drive;
}

double spindleTorque(const LatheSpindle& spindle, double speed) {
  const SpindleDrive drive = driveOf(spindle);
  const double n = std::abs(speed);
  return n > 0.0 ? std::min(drive.torque, drive.power * drive.efficiency * kKilowatt / n) : drive.torque;
}

void LatheWarnings::judge(const std::vector<CutWarning>& broken, double time, const std::string& tool) {
  for (const CutWarning& warning : broken) {
    Open& open = m_open[static_cast<std::size_t>(warning.rule)];
    const bool isSame = open.isOpen && time - open.last < kApart && m_all[open.entry].tool == tool;
    open.last = time;
    if (isSame) {
      CutWarning& recorded = m_all[open.entry].warning;
      // The thinnest of several thin chips is the worst.
      const bool isWorse =
          warning.rule == CutWarning::Rule::Rubbing ? warning.value < recorded.value : warning.value > recorded.value;
      if (!isWorse) continue;
      recorded = warning;
    } else {
      if (m_all.size() >= kMost) continue;
      open.isOpen = true;
      open.entry = m_all.size();
      m_all.push_back({warning, time, tool});
    }
    ++m_changes;
  }
}

}  // namespace handwheel
