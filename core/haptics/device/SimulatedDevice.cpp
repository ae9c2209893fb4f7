// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/device/SimulatedDevice.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {
constexpr double kStep = 1e-4;                // s
constexpr double kMillimetresPerMetre = 1e3;  // N = kg·m/s²
}  // namespace

SimulatedDeviceSettings simulatedDevice() {
  SimulatedDeviceSettings settings;
  DeviceCapabilities& device = settings.capabilities;
  device.inputs = 6;
  device.buttons = 4;
  device.maxForce = 8.0;
  device.maxStiffness = 3.0;
  device.maxDamping = 0.02;
  device.workspaceRadius = 40.0;
  device.inherentDamping = 0.0005;
  return settings;
}

SimulatedDeviceSettings simulatedTorqueDevice() {
  SimulatedDeviceSettings settings = simulatedDevice();
  settings.capabilities.outputs = 6;
  settings.capabilities.maxTorque = 200.0;
  settings.capabilities.maxAngularStiffness = 1000.0;
  return settings;
}

SimulatedDevice::SimulatedDevice(const SimulatedDeviceSettings& settings, PoseTrajectory path, ServoClock& clock)
    : m_settings(settings), m_path(std::move(path)), m_clock(clock) {}

Status SimulatedDevice::open(Progress) {
  m_isOpen = true;
  return Done{};
}

void SimulatedDevice::close() noexcept {
  m_isOpen = false;
}

void SimulatedDevice::setStart(const Vec3& position, const Vec3& velocity) {
  m_position = position;
  m_velocity = velocity;
  m_hasStart = true;
}

DeviceState SimulatedDevice::read() noexcept {
  DeviceState state;
  if (!m_isOpen) return state;
  if (!m_hasBegun) m_origin = m_clock.now();
  const double time = static_cast<double>(m_clock.now() - m_origin) / kNanoseconds;
  if (!m_hasBegun) begin(time);
  const HandPose hand = wanted(time);
  if (m_settings.isCommanded) {
    m_time = time;
    m_position = hand.position;
  } else {
    moveTo(time);
  }
  state.status = DeviceStatus::Ready;
  state.position = m_position;
  state.orientation = hand.orientation;
  state.buttons = hand.buttons;
  return state;
}

void SimulatedDevice::write(const DeviceForce& force) noexcept {
  if (!m_hasBegun) return;
  const double now = static_cast<double>(m_clock.now() - m_origin) / kNanoseconds;
  if (m_count == m_sent.size()) {
    m_first = (m_first + 1) % m_sent.size();
    --m_count;
  }
  m_sent[(m_first + m_count++) % m_sent.size()] = {now + m_settings.capabilities.latency, force};
}

HandPose SimulatedDevice::wanted(double time) noexcept {
  return m_path.isEmpty() ? m_target.read() : m_path.at(time);
}

void SimulatedDevice::begin(double time) noexcept {
  m_hasBegun = true;
  if (!m_hasStart) m_position = wanted(time).position;
}

void SimulatedDevice::moveTo(double time) noexcept {
  while (m_count > 0 && m_sent[m_first].time <= time) {
    moveUnder(m_acting.force, m_sent[m_first].time);
    m_acting = m_sent[m_first].force;
    m_first = (m_first + 1) % m_sent.size();
    --m_count;
  }
  moveUnder(m_acting.force, time);
}

void SimulatedDevice::moveUnder(const Vec3& force, double until) noexcept {
  const double seconds = until - m_time;
  if (!(seconds > 0.0)) return;  // a clock that goes back moves nothing
  const HandGrip& grip = m_settings.grip;
  const bool isLoose = grip.stiffness == 0.0 && grip.integral == 0.0 && grip.damping == 0.0;
  const int steps = isLoose ? 1 : static_cast<int>(std::min(std::ceil(seconds / kStep), 1e5));
  for (int i = 0; i < steps; ++i) step(force, seconds / steps);
  m_time = until;
}

// m·dv/dt = f - c·v under constant f: with z = c·t/m, the velocity changes by (f - c·v)·t/m·p(z) and the position by
// v·t·p(z) + f·t²/m·q(z), where p = (1 - exp(-z))/z and q = (1 - p)/z. Near z = 0, where the quotients lose digits, by
// their series.
void SimulatedDevice::step(const Vec3& force, double seconds) noexcept {
  const double mass = m_settings.mass / kMillimetresPerMetre;  // N·s²/mm
  const double damping = m_settings.capabilities.inherentDamping + m_settings.grip.damping;
  const Vec3 constant = force + pull(seconds);
  const double z = damping * seconds / mass;
  const bool isSmall = z < 1e-3;
  const double p = isSmall ? 1.0 - z / 2.0 * (1.0 - z / 3.0 * (1.0 - z / 4.0)) : -std::expm1(-z) / z;
  const double q = isSmall ? 0.5 - z / 6.0 * (1.0 - z / 4.0 * (1.0 - z / 5.0)) : (1.0 - p) / z;
  m_position += seconds * p * m_velocity + (seconds * seconds / mass * q) * constant;
  m_velocity += (seconds / mass * p) * (constant - damping * m_velocity);
}

// The force of the hand without its damping, which the step has in its exact part; taken at the middle of the step.
Vec3 SimulatedDevice::pull(double seconds) noexcept {
  const HandGrip& grip = m_settings.grip;
  if (grip.stiffness == 0.0 && grip.integral == 0.0 && grip.damping == 0.0) return Vec3::Zero();
  const Vec3 before = wanted(m_time).position, after = wanted(m_time + seconds).position;
  const Vec3 off = 0.5 * (before + after) - (m_position + 0.5 * seconds * m_velocity);
  m_error += seconds * off;
  const Vec3 force = grip.stiffness * off + grip.integral * m_error + (grip.damping / seconds) * (after - before);
  const double size = force.norm();
  return size > grip.maxForce ? Vec3(force * (grip.maxForce / size)) : force;
}

}  // namespace handwheel
