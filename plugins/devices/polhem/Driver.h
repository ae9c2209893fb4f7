// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

namespace handwheel::polhem {

// Driver of the Polhem on a serial port. It finds the serial ports of the board that the Polhem is built on, a Teensy
// (USB 16c0:0483). Other products use the same board, so a port is opened only when the user chooses it. The
// environment variable HANDWHEEL_POLHEM_PORT adds a port that is not found in this manner. The reaction of the motors
// to a loss of communication is not known; therefore a separate process holds the device (Guard.cpp).
class Driver final : public DeviceDriver {
 public:
  explicit Driver(std::string sysfs = "/sys/class/tty", std::string dev = "/dev")
      : m_sysfs(std::move(sysfs)), m_dev(std::move(dev)) {}

  std::string id() const override { return "polhem"; }
  std::vector<DeviceInfo> find() override;
  std::unique_ptr<Device> make(const std::string& address) override;

 private:
  std::string m_sysfs;
  std::string m_dev;
};

}  // namespace handwheel::polhem
