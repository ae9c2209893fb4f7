// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/ByteStream.h"
#include "io/Session.h"

#include <functional>
#include <memory>

namespace handwheel {

// Session of a fictitious example device. The device answers every force with its position. Force and position are
// three signed 16-bit numbers each, low byte first: mN along x, y and z, and hundredths of a mm.
class ExampleSession final : public Session {
 public:
  using Connect = std::function<Result<std::unique_ptr<ByteStream>>()>;
  explicit ExampleSession(Connect connect) : m_connect(std::move(connect)) {}

  DeviceCapabilities capabilities() const override;
  Status open(Progress progress) override;
  DeviceState exchange(const DeviceForce& force) noexcept override;
  void close() noexcept override;

 private:
  bool send(const Vec3& force) noexcept;
  bool receive() noexcept;  // returns true if a whole answer was received; m_stream is null if the device is gone

  Connect m_connect;
  std::unique_ptr<ByteStream> m_stream;
  DeviceState m_state;
};

}  // namespace handwheel
