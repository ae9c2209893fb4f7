// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haply/Messages.h"
#include "haply/WebSocket.h"
#include "io/Session.h"

#include <functional>

namespace handwheel::haply {

// Session of a Haply device that uses the manufacturer's service. The service answers each message with one frame, and
// sends no frames by itself. So each exchange consists of one message and one frame. A late answer is awaited before
// the next message is sent, because otherwise answers and messages would be out of step permanently.
class Session final : public handwheel::Session {
 public:
  using Connect = std::function<Result<std::unique_ptr<ByteStream>>()>;
  Session(Connect connect, std::shared_ptr<Clock> clock) : m_connect(std::move(connect)), m_clock(std::move(clock)) {}

  DeviceCapabilities capabilities() const override;
  Status open(Progress progress) override;
  DeviceState exchange(const DeviceForce& force) noexcept override;
  void close() noexcept override;

 private:
  void understand(const Frame& frame);

  Connect m_connect;
  std::shared_ptr<Clock> m_clock;
  std::unique_ptr<WebSocket> m_socket;  // null: the connection is not open, or is gone
  std::string m_deviceId;
  bool m_hasGrip = false;
  bool m_asked = false;  // true: a message was sent that is not answered yet
  double m_lastAnswer = 0.0;
  DeviceState m_state;
};

}  // namespace handwheel::haply
