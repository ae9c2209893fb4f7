// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/ByteStream.h"
#include "io/Clock.h"
#include "io/DeviceHostMessages.h"
#include "io/Session.h"

#include <functional>
#include <memory>

namespace handwheel {

// Session with a device that another process holds (guard::SessionHost). The motors stop when this program dies. The
// two processes communicate over a stream; each exchange costs a round trip, about 0.1 ms.
class OutOfProcessSession final : public Session {
 public:
  using Connect = std::function<Result<std::unique_ptr<ByteStream>>()>;  // starts the process
  // kind: the capabilities to report until the device itself has been queried; name: the name of the device, for error
  // messages.
  OutOfProcessSession(Connect connect, std::shared_ptr<Clock> clock, const DeviceCapabilities& kind, std::string name)
      : m_connect(std::move(connect)), m_clock(std::move(clock)), m_capabilities(kind), m_name(std::move(name)) {}

  DeviceCapabilities capabilities() const override { return m_capabilities; }
  Status open(Progress progress) override;
  DeviceState exchange(const DeviceForce& force) noexcept override;
  void close() noexcept override;

 private:
  Result<DeviceCapabilities> waitForDevice(Progress progress);
  bool send(const guard::Message& message) noexcept;
  std::optional<guard::Message> receive(double until) noexcept;
  void leave() noexcept { m_stream.reset(); }

  Connect m_connect;
  std::shared_ptr<Clock> m_clock;
  DeviceCapabilities m_capabilities;
  std::string m_name;
  std::unique_ptr<ByteStream> m_stream;  // null: the session is not open, or the process is gone
  guard::Reader m_reader;
  guard::Buffer m_out{};
  std::array<std::uint8_t, 2 * guard::kLargestMessage> m_in{};
  std::uint32_t m_number = 0;
  double m_lastAnswer = 0.0;
  DeviceState m_state;
};

}  // namespace handwheel
