// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/safety/SafetyChain.h"

#include "haptics/safety/ForceLimits.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// mm: a thousand kilometres, beyond the reach of devices and scenes; below, squares and their sums stay finite.
constexpr double kFarthest = 1e9;

bool isReading(const SafetyInput& input) {
  return input.isDeviceReady && input.position.allFinite() && input.position.stableNorm() < kFarthest &&
         input.velocity.allFinite() && std::isfinite(input.stepSpeed) && input.period > 0.0;
}

// Removes components for which the device has no motors.
DeviceForce given(DeviceForce asked, const SafetySettings& settings) {
  if (settings.maxTorque == 0.0) asked.torque.setZero();
  if (settings.maxGripperForce == 0.0) asked.gripper = 0.0;
  return asked;
}

bool differ(const DeviceForce& a, const DeviceForce& b) {
  return a.force != b.force || a.torque != b.torque || a.gripper != b.gripper;
}

}  // namespace

SafetyChain::SafetyChain(const SafetySettings& settings)
    : m_settings(settings), m_passivity(settings), m_speed(settings), m_ramp(settings), m_watchdog(settings) {}

SafetyOutput SafetyChain::process(const SafetyInput& input) noexcept {
  if (!isReading(input)) {
    // The positions of a device that is not to be trusted tell nothing of energy either.
    m_passivity.reset();
    return fault(SafetyAction::DeviceFault);
  }
  m_passivity.observe(input.position, input.period);
  const bool isCut = m_speed.cuts(std::max(input.velocity.norm(), input.stepSpeed));
  if (!isFinite(input.asked)) return fault(SafetyAction::NotFinite);
  if (isCut) return fault(SafetyAction::SpeedCut);
  if (input.isDiscontinuous) m_ramp.restart();

  SafetyOutput output;
  DeviceForce force = given(input.asked, m_settings);
  damp(input, force, output.actions);
  scale(input, force, output.actions);
  if (!isFinite(force)) return fault(SafetyAction::NotFinite);  // sums of huge values
  const double seconds = std::min(input.period, 2.0 * m_settings.nominalPeriod);
  const DeviceForce slow = slewed(m_last, force, seconds, m_settings);
  if (differ(slow, force)) output.actions.add(SafetyAction::Slew);
  output.sent = clamped(slow, m_settings);
  if (differ(output.sent, slow)) output.actions.add(SafetyAction::Clamp);
  m_last = output.sent;
  m_passivity.sent(output.sent.force);
  output.energy = m_passivity.energy();
  return output;
}

SafetyOutput SafetyChain::fault(SafetyAction why) {
  m_ramp.restart();
  m_watchdog.reset();
  m_last = {};
  m_passivity.sent(Vec3::Zero());
  SafetyOutput output;
  output.actions.add(why);
  output.energy = m_passivity.energy();
  return output;
}

void SafetyChain::damp(const SafetyInput& input, DeviceForce& force, SafetyActions& actions) {
  // Free space stays free: the friction of the device dissipates the rest of the last contact.
  const Vec3 correction = force.force.isZero(0.0) ? Vec3::Zero().eval() : m_passivity.correction();
  if (!correction.isZero(0.0)) actions.add(SafetyAction::Passivity);
  const Vec3 damping = m_speed.damping(input.velocity);
  if (!damping.isZero(0.0)) actions.add(SafetyAction::SpeedDamping);
  force.force += correction + damping;
}

void SafetyChain::scale(const SafetyInput& input, DeviceForce& force, SafetyActions& actions) {
  const double ramp = m_ramp.gain(input.asked.force.stableNorm(), input.period);
  if (ramp < 1.0) actions.add(SafetyAction::Ramp);
  const Watchdog::Gains watchdog = m_watchdog.tick(input.period, input.isFresh);
  if (watchdog.force < 1.0) actions.add(SafetyAction::Watchdog);
  const double gain = ramp * watchdog.force;
  force.force = gain * force.force - watchdog.damping * m_settings.speedDamping * input.velocity;
  force.torque *= gain;
  force.gripper *= gain;
}

}  // namespace handwheel
