// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "example/Session.h"

#include "io/Capabilities.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {

namespace {

using Packet = std::array<std::uint8_t, 6>;

constexpr double kExchange = 0.001;  // s
constexpr double kMillinewton = 1e-3;
constexpr double kStep = 0.01;         // mm
constexpr double kAnswerTime = 0.005;  // s

void put(Packet& packet, std::size_t axis, double value) {
  const auto number = static_cast<std::int16_t>(std::clamp(std::round(value), -32767.0, 32767.0));
  packet[2 * axis] = static_cast<std::uint8_t>(number & 0xff);
  packet[2 * axis + 1] = static_cast<std::uint8_t>((number >> 8) & 0xff);
}

double number(const Packet& packet, std::size_t axis) {
  return static_cast<std::int16_t>(packet[2 * axis] | packet[2 * axis + 1] << 8);
}

}  // namespace

DeviceCapabilities ExampleSession::capabilities() const {
  DeviceCapabilities all;
  all.maxForce = 5.0;
  all.maxStiffness = 1.0;
  all.maxDamping = 0.005;
  all.workspaceRadius = 100.0;
  all.inherentDamping = inherentDampingFor(all.maxStiffness, all.nominalRate, kExchange);
  all.latency = kExchange + kHandOver;
  return all;
}

Status ExampleSession::open(Progress) {
  auto stream = m_connect();
  if (!stream) return stream.error();
  m_stream = std::move(stream.value());
  m_state = {};
  m_state.status = DeviceStatus::Starting;  // until it has reported its position
  return Done{};
}

DeviceState ExampleSession::exchange(const DeviceForce& force) noexcept {
  if (!m_stream) return {};
  if (!send(force.force)) m_stream.reset();
  if (m_stream && receive()) {
    m_state.status = DeviceStatus::Ready;
    ++m_state.reading;  // otherwise there is no new reading, and the force fades
  }
  return m_stream ? m_state : DeviceState();
}

void ExampleSession::close() noexcept {
  if (m_stream) (void)send(Vec3::Zero());
  m_stream.reset();
}

bool ExampleSession::send(const Vec3& force) noexcept {
  Packet packet{};
  for (std::size_t axis = 0; axis < 3; ++axis) put(packet, axis, force[static_cast<int>(axis)] / kMillinewton);
  return m_stream->write(packet);
}

bool ExampleSession::receive() noexcept {
  Packet packet{};
  std::size_t filled = 0;
  while (filled < packet.size()) {
    const std::ptrdiff_t count = m_stream->read(std::span(packet).subspan(filled), kAnswerTime);
    if (count == kGone) m_stream.reset();
    if (count <= 0) return false;
    filled += static_cast<std::size_t>(count);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) m_state.position[static_cast<int>(axis)] = number(packet, axis) * kStep;
  return true;
}

}  // namespace handwheel
