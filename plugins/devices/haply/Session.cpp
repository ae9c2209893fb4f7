// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haply/Session.h"

#include "haptics/device/DeviceErrors.h"
#include "io/Capabilities.h"

namespace handwheel::haply {

namespace {

// Time of one exchange, s. Inverse3 devices answer at 1 kHz and more, as their manufacturer recommends, through the
// library and through the service.
constexpr double kExchange = 0.001;
constexpr double kAnswerTime = 0.01;    // s
constexpr double kInventoryTime = 2.0;  // s
constexpr double kSilence = 0.1;        // s without a valid frame until the device counts as failed

}  // namespace

DeviceCapabilities Session::capabilities() const {
  DeviceCapabilities all;
  all.inputs = m_hasGrip ? 6 : 3;
  all.buttons = 3;
  all.maxForce = 10.0;
  all.maxStiffness = 1.0;  // CHAI3D with the maker's library (chai3d_haply): one exchange for each force, at 1 kHz
  all.maxDamping = 0.006;
  all.workspaceRadius = 150.0;
  all.inherentDamping = inherentDampingFor(all.maxStiffness, all.nominalRate, kExchange);
  all.latency = kExchange + kHandOver;
  return all;
}

Status Session::open(Progress) {
  auto stream = m_connect();
  if (!stream) return stream.error();
  auto socket = WebSocket::open(std::move(stream.value()), m_clock, "localhost");
  if (!socket) return socket.error();
  m_socket = std::move(socket.value());
  m_state = {};
  m_state.status = DeviceStatus::Starting;
  (void)m_socket->send(clientHello());
  const std::optional<std::string> inventory = m_socket->receive(kInventoryTime);
  const std::optional<Frame> frame = inventory ? readFrame(*inventory) : std::nullopt;
  if (!frame) return Error{DeviceError::NotResponding, {"an inventory with an Inverse3"}, {}, "Haply Inverse3"};
  m_deviceId = frame->deviceId;
  m_hasGrip = frame->orientation.has_value();
  m_lastAnswer = m_clock->now();
  m_asked = m_socket->send(centringCommand(m_deviceId));
  return Done{};
}

DeviceState Session::exchange(const DeviceForce& force) noexcept {
  if (!m_socket) return {};
  const bool late = m_clock->now() - m_lastAnswer > kSilence;
  if (!m_asked || late) m_asked = m_socket->send(forceCommand(m_deviceId, force.force));
  const std::optional<std::string> text = m_socket->receive(kAnswerTime);
  if (text) m_asked = false;
  if (const std::optional<Frame> frame = text ? readFrame(*text) : std::nullopt) {
    m_lastAnswer = m_clock->now();
    understand(*frame);
  } else if (late) {
    m_state.status = DeviceStatus::Failed;
  }
  if (!m_socket->isGone()) return m_state;
  m_socket.reset();
  return {};
}

// Commands do not outlive the message after them, so the service itself releases the force when nothing more comes;
// this is sooner.
void Session::close() noexcept {
  if (m_socket && !m_deviceId.empty()) (void)m_socket->send(forceCommand(m_deviceId, Vec3::Zero()));
  if (m_socket) m_socket->sendClose();
  m_socket.reset();
}

void Session::understand(const Frame& frame) {
  if (!frame.position) return;
  ++m_state.reading;
  m_state.position = *frame.position;
  m_state.hasVelocity = frame.velocity.has_value();
  m_state.velocity = frame.velocity.value_or(Vec3::Zero());
  if (frame.orientation) m_state.orientation = *frame.orientation;
  m_state.buttons = frame.buttons;
  m_state.status = frame.isCalibrated ? DeviceStatus::Ready : DeviceStatus::NeedsHoming;
}

}  // namespace handwheel::haply
