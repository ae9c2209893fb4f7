// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/LatheWarnings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr double kKilowatt = 60'000.0 / (2.0 * M_PI);  // N·m times r/min in a kW

double fourthPower(double r) {
  return r * r * r * r;
}

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

SlenderWork beamOf(const TurnedProfile& part, double grip, double position) {
  SlenderWork beam;
  beam.position = std::max(0.0, position - grip);
  beam.length = 0.0;
  double compliance = 0.0, weight = 0.0, outer = 0.0;  // compliance is weighted by 1 / (r⁴ - inner⁴)
  for (std::size_t i = 0; i < part.size(); ++i) {
    const double z = part.z(i);
    if (z < grip) continue;
    if (!(part.radius(i) > part.inner(i))) break;
    if (outer == 0.0) outer = part.radius(i);  // for a cut beside the jaws
    if (z <= std::max(position, grip)) {
      const double arm = position - z + 0.5 * part.spacing();
      const double stiff = fourthPower(part.radius(i)) - fourthPower(part.inner(i));
      compliance += arm * arm / stiff;
      weight += arm * arm;
      outer = part.radius(i);
    }
    beam.length = z - grip;
  }
  beam.position = std::min(beam.position, beam.length);
  beam.diameter = compliance > 0.0 ? 2.0 * std::pow(weight / compliance, 0.25) : 2.0 * outer;
  return beam;
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
