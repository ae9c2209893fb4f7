// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/OutOfProcessSession.h"

#include "haptics/device/DeviceErrors.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr double kHop = 0.0002;            // s, there and back
constexpr double kOpeningLookTime = 0.05;  // s between checks for a cancel
constexpr double kOpeningSilence = 5.0;    // s without a message while it opens the device
constexpr double kAnswerTime = 0.02;       // s
constexpr double kSilence = 0.1;           // s without an answer until the device counts as failed
constexpr double kClosingTime = 1.0;       // s that it may take to send zero force and go

}  // namespace

Status OutOfProcessSession::open(Progress progress) {
  auto stream = m_connect();
  if (!stream) return stream.error();
  m_stream = std::move(stream.value());
  m_reader = {};
  m_state = {};
  m_state.status = DeviceStatus::Starting;
  const Result<DeviceCapabilities> opened = waitForDevice(progress);
  if (!opened) return opened.error();
  m_capabilities = *opened;
  m_capabilities.latency += kHop;
  m_lastAnswer = m_clock->now();
  return Done{};
}

Result<DeviceCapabilities> OutOfProcessSession::waitForDevice(Progress progress) {
  (void)send(guard::Open{});
  double heard = m_clock->now();
  while (m_stream && m_clock->now() - heard < kOpeningSilence) {
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    const std::optional<guard::Message> message = receive(m_clock->now() + kOpeningLookTime);
    if (!message) continue;
    heard = m_clock->now();
    if (const auto* opening = std::get_if<guard::Opening>(&*message)) progress.set(opening->fraction);
    if (const auto* refused = std::get_if<guard::Refused>(&*message)) return refused->error;
    if (const auto* opened = std::get_if<guard::Opened>(&*message)) return opened->capabilities;
  }
  return Error{DeviceError::Unreachable, {"the process that guards its motors has ended"}, {}, m_name};
}

// A late answer is that to an earlier force, and skipped.
DeviceState OutOfProcessSession::exchange(const DeviceForce& force) noexcept {
  if (!m_stream || !send(guard::Force{++m_number, force})) return {};
  const double end = m_clock->now() + kAnswerTime;
  while (const std::optional<guard::Message> message = receive(end)) {
    const auto* answer = std::get_if<guard::State>(&*message);
    if (!answer) continue;
    m_state = answer->state;
    m_lastAnswer = m_clock->now();
    if (answer->number == m_number) return m_state;
  }
  if (!m_stream) return {};
  if (m_clock->now() - m_lastAnswer > kSilence) m_state.status = DeviceStatus::Failed;
  return m_state;
}

// The device has zero force once the process has closed its end.
void OutOfProcessSession::close() noexcept {
  const double end = m_clock->now() + kClosingTime;
  if (m_stream && send(guard::Close{})) {
    while (m_stream && m_clock->now() < end) (void)receive(end);
  }
  leave();
}

bool OutOfProcessSession::send(const guard::Message& message) noexcept {
  if (!m_stream->write(guard::bytesOf(message, m_out))) leave();
  return m_stream != nullptr;
}

// Returns the next message, or nothing if none came until then or the process is gone.
std::optional<guard::Message> OutOfProcessSession::receive(double until) noexcept {
  while (m_stream) {
    if (std::optional<guard::Message> message = m_reader.next()) return message;
    const std::ptrdiff_t count =
        m_reader.isBroken() ? kGone : m_stream->read(m_in, std::max(0.0, until - m_clock->now()));
    if (count == kGone) leave();
    if (count <= 0) break;
    m_reader.add(std::span(m_in).first(static_cast<std::size_t>(count)));
  }
  return std::nullopt;
}

}  // namespace handwheel
