// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spacemouse/SocketSession.h"

namespace handwheel::spacemouse {

Status SocketSession::open(Progress) {
  auto stream = m_connect();
  if (!stream) return stream.error();
  m_stream = std::move(stream.value());
  m_records = {};
  return Done{};
}

DeviceState SocketSession::exchange(const DeviceForce&) noexcept {
  constexpr double kWait = 0.016;  // s
  std::array<std::uint8_t, 1024> bytes{};
  const std::ptrdiff_t count = m_stream ? m_stream->read(bytes, kWait) : kGone;
  if (count == kGone) {
    m_stream.reset();
    return {};
  }
  m_records.take(std::span(bytes).first(static_cast<std::size_t>(count)));
  DeviceState state;
  state.status = DeviceStatus::Ready;
  state.buttons = m_records.buttons();
  setPose(m_records.counts(), state);
  return state;
}

}  // namespace handwheel::spacemouse
