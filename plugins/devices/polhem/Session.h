// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/ByteStream.h"
#include "io/Clock.h"
#include "io/Session.h"
#include "polhem/Lines.h"

#include <functional>
#include <memory>

namespace handwheel::polhem {

// A session with a Polhem device on a serial port. Each exchange sends a force and receives a reading. In the device's
// own frame, x points towards the user, y to the right and z up.
class Session final : public handwheel::Session {
 public:
  using Connect = std::function<Result<std::unique_ptr<ByteStream>>()>;
  Session(Connect connect, std::shared_ptr<Clock> clock) : m_connect(std::move(connect)), m_clock(std::move(clock)) {}

  DeviceCapabilities capabilities() const override;
  Status open(Progress progress) override;
  DeviceState exchange(const DeviceForce& force) noexcept override;
  void close() noexcept override;

 private:
  bool send(const Vec3& force) noexcept;
  bool receive(double timeout) noexcept;  // returns true if a reading arrived; resets m_stream if the device is gone

  Connect m_connect;
  std::shared_ptr<Clock> m_clock;
  std::unique_ptr<ByteStream> m_stream;
  LineReader m_lines;
  DeviceState m_state;
  double m_lastAnswer = 0.0;
};

}  // namespace handwheel::polhem
