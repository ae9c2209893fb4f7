// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "falcon/Bootloader.h"
#include "falcon/Packet.h"
#include "io/Session.h"

#include <functional>

namespace handwheel::falcon {

// Session of a Novint Falcon, from its port to the servo loop. No torque is sent before all three arms are homed: until
// then the position of the device is unknown, and it jumps when it becomes known. To home the arms, the user pulls the
// grip out and pushes it in. The light is red until then.
class Session final : public handwheel::Session {
 public:
  using Connect = std::function<Result<std::unique_ptr<UsbTransport>>()>;
  using ReadFirmware = std::function<Result<Firmware>()>;  // called only if the device has no firmware
  Session(Connect connect, ReadFirmware readFirmware, std::shared_ptr<Clock> clock)
      : m_connect(std::move(connect)), m_readFirmware(std::move(readFirmware)), m_clock(std::move(clock)) {}

  DeviceCapabilities capabilities() const override;
  Status open(Progress progress) override;
  DeviceState exchange(const DeviceForce& force) noexcept override;
  void close() noexcept override;

 private:
  bool converse(const Counts& torques, std::uint8_t lights) noexcept;  // returns true if an answer came
  bool listen(double timeout) noexcept;
  Counts torquesFor(const Vec3& force) const noexcept;
  void understand() noexcept;

  Connect m_connect;
  ReadFirmware m_readFirmware;
  std::shared_ptr<Clock> m_clock;
  std::unique_ptr<FtdiPort> m_port;  // null: the port is not open, or the device is gone
  AnswerReader m_answers;
  bool m_missed = false;  // true: the last packet was not answered in time
  DeviceState m_state;
  Vec3 m_point = kHome;  // m, position in the frame of the mechanism
  double m_lastAnswer = 0.0;
};

}  // namespace handwheel::falcon
