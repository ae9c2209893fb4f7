// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "falcon/Session.h"

#include "haptics/device/DeviceErrors.h"
#include "io/Capabilities.h"

namespace handwheel::falcon {

namespace {

// Time of one exchange, a packet out and one in, s. libnifalcon and other programs reach 1 kHz, for which the frames of
// a full-speed bus are the limit.
constexpr double kExchange = 0.001;
constexpr double kMillimetre = 1e-3;   // m
constexpr double kAnswerTime = 0.004;  // s; it answers within one or two frames of the bus
constexpr double kLateTime = 0.001;    // s, wait for an answer that was missed
constexpr double kSilence = 0.1;       // s without an answer until the device counts as failed
constexpr int kFarewells = 3;          // zero packets on leaving: its behaviour without them is not known

}  // namespace

DeviceCapabilities Session::capabilities() const {
  DeviceCapabilities all;
  all.buttons = 4;
  all.maxForce = 8.0;
  all.maxStiffness = 3.0;  // CHAI3D 3.3.0, for a loop of 1 kHz that makes one exchange in each tick
  all.maxDamping = 0.020;
  all.workspaceRadius = 40.0;
  all.inherentDamping = inherentDampingFor(all.maxStiffness, all.nominalRate, kExchange);
  all.latency = kExchange + kHandOver;
  return all;
}

Status Session::open(Progress progress) {
  auto usb = m_connect();
  if (!usb) return usb.error();
  m_port = std::make_unique<FtdiPort>(std::move(usb.value()));
  m_answers.clear();
  m_missed = false;
  m_state = {};
  m_state.status = DeviceStatus::Starting;
  m_point = kHome;
  if (!runs(*m_port, *m_clock)) {
    if (m_port->isGone()) return Error{DeviceError::Unreachable, {"unplugged"}, {}, "Novint Falcon"};
    const Result<Firmware> firmware = m_readFirmware();
    if (!firmware) return firmware.error();
    const Status loaded = loadFirmware(*m_port, *m_clock, *firmware, progress);
    if (!loaded) return loaded;
  }
  m_lastAnswer = m_clock->now();
  return Done{};
}

DeviceState Session::exchange(const DeviceForce& force) noexcept {
  if (!m_port) return {};
  const bool homed = m_state.status == DeviceStatus::Ready;
  const std::uint8_t lights = homed ? kGreen : kHoming | kRed;
  if (converse(homed ? torquesFor(force.force) : Counts{}, lights)) {
    m_lastAnswer = m_clock->now();
    understand();
  } else if (m_port->isGone()) {
    m_port.reset();
    return {};
  } else if (m_clock->now() - m_lastAnswer > kSilence) {
    m_state.status = DeviceStatus::Failed;
  }
  return m_state;
}

void Session::close() noexcept {
  for (int i = 0; m_port && !m_port->isGone() && i < kFarewells; ++i) (void)converse({}, kHoming | kRed);
  m_port.reset();
}

// Sends one packet and receives one. A missed answer may still come: it is read before the next question, or every
// later answer would belong to the question before.
bool Session::converse(const Counts& torques, std::uint8_t lights) noexcept {
  if (m_missed) (void)listen(kLateTime);
  m_missed = !m_port->write(encode(torques, lights)) || !listen(kAnswerTime);
  return !m_missed;
}

bool Session::listen(double timeout) noexcept {
  std::array<std::uint8_t, 256> bytes{};
  const double end = m_clock->now() + timeout;
  do {
    const std::ptrdiff_t count = m_port->read(bytes, end - m_clock->now());
    if (count == kGone) return false;
    if (m_answers.take(std::span(bytes).first(static_cast<std::size_t>(count))) > 0) return true;
  } while (m_clock->now() < end);
  return false;
}

Counts Session::torquesFor(const Vec3& force) const noexcept {
  return torqueCounts(torques(force, m_point));
}

// Computes the pose from the last answer. Angles that the mechanism cannot take are a fault of the line.
void Session::understand() noexcept {
  const Reading& reading = m_answers.reading();
  ++m_state.reading;
  m_state.buttons = reading.buttons;
  m_state.status = reading.isHomed() ? DeviceStatus::Ready : DeviceStatus::NeedsHoming;
  if (!reading.isHomed()) return;
  const Angles angles = anglesOf(reading.encoders);
  std::optional<Vec3> point = forward(angles, m_point);
  if (!point) point = forward(angles, kHome);
  if (!point) {
    m_state.status = DeviceStatus::Failed;
    return;
  }
  m_point = *point;
  m_state.position = (m_point - kCentre) / kMillimetre;
}

}  // namespace handwheel::falcon
