// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "falcon/LibusbTransport.h"
#include "haptics/device/Device.h"

namespace handwheel::falcon {

// Driver of the Novint Falcon. The behaviour of its motors when communication stops is not known. Therefore a separate
// process holds the device (Guard.cpp), and sends zero torque when the program dies.
class Driver final : public DeviceDriver {
 public:
  std::string id() const override { return "falcon"; }
  std::vector<DeviceInfo> find() override;
  std::unique_ptr<Device> make(const std::string& address) override;

 private:
  Usb m_usb;
};

}  // namespace handwheel::falcon
