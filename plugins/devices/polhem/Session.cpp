// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "polhem/Session.h"

#include "haptics/device/DeviceErrors.h"
#include "io/Capabilities.h"

#include <algorithm>

namespace handwheel::polhem {

namespace {

// Time of one exchange, a line out and one in, in a frame of a full-speed bus, s.
constexpr double kExchange = 0.001;
constexpr double kAnswerTime = 0.005;  // s
constexpr double kSilence = 0.1;       // s without a reading until the device counts as failed
constexpr double kWakeTime = 0.1;      // s for one attempt to wake it: opening the line may have reset its board
constexpr int kWakes = 30;

// Returns the rotation from x towards the user, y right, z up to x right, y up, z towards the user; the same axes in
// another order.
const Eigen::Matrix3d& toOurs() {
  static const Eigen::Matrix3d kTurn = (Eigen::Matrix3d() << 0, 1, 0, 0, 0, 1, 1, 0, 0).finished();
  return kTurn;
}

}  // namespace

DeviceCapabilities Session::capabilities() const {
  DeviceCapabilities all;
  all.inputs = 6;
  all.maxForce = 5.0;
  all.maxStiffness = 1.5;  // the manufacturer's CHAI3D, whose loop of 1 kHz waits for a line and answers it
  all.maxDamping = 0.003;
  all.workspaceRadius = 100.0;
  all.inherentDamping = inherentDampingFor(all.maxStiffness, all.nominalRate, kExchange);
  all.latency = kExchange + kHandOver;
  return all;
}

Status Session::open(Progress progress) {
  auto stream = m_connect();
  if (!stream) return stream.error();
  m_stream = std::move(stream.value());
  m_lines = {};
  m_state = {};
  m_state.status = DeviceStatus::Starting;
  for (int i = 0; m_stream && i < kWakes; ++i) {
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    if (send(Vec3::Zero()) && receive(kWakeTime)) return Done{};
  }
  if (m_stream) return Error{DeviceError::NotResponding, {"its position"}, {}, "Polhem"};
  return Error{DeviceError::Unreachable, {"unplugged"}, {}, "Polhem"};
}

DeviceState Session::exchange(const DeviceForce& force) noexcept {
  if (!m_stream) return {};
  (void)receive(0.0);  // a late line; else every later answer would belong to the question before
  if (m_stream && send(toOurs().transpose() * force.force) && !receive(kAnswerTime) &&
      m_clock->now() - m_lastAnswer > kSilence) {
    m_state.status = DeviceStatus::Failed;
  }
  return m_stream ? m_state : DeviceState();
}

void Session::close() noexcept {
  if (m_stream) (void)send(Vec3::Zero());
  m_stream.reset();
}

bool Session::send(const Vec3& force) noexcept {
  if (!m_stream->write(forceLine(force))) m_stream.reset();
  return m_stream != nullptr;
}

bool Session::receive(double timeout) noexcept {
  std::array<std::uint8_t, 1024> bytes{};
  const double end = m_clock->now() + timeout;
  do {
    const std::ptrdiff_t count = m_stream->read(bytes, std::max(0.0, end - m_clock->now()));
    if (count == kGone) {
      m_stream.reset();
      return false;
    }
    if (m_lines.take(std::span(bytes).first(static_cast<std::size_t>(count))) == 0) continue;
    m_lastAnswer = m_clock->now();
    const Reading& reading = m_lines.reading();
    ++m_state.reading;
    m_state.status = DeviceStatus::Ready;
    m_state.position = toOurs() * reading.position;
    m_state.orientation = Eigen::Quaterniond(toOurs()) * reading.orientation();
    m_state.orientation.normalize();
    return true;
  } while (m_clock->now() < end);
  return false;
}

}  // namespace handwheel::polhem
