// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "falcon/LibusbTransport.h"
#include "haptics/Device.h"

namespace handwheel::falcon {

// Its firmware belongs to its maker and is not ours to ship: the user puts the file where firmwarePath() says.
class Driver final : public DeviceDriver {
 public:
  std::string id() const override { return "falcon"; }
  std::vector<DeviceListing> find() override;
  std::unique_ptr<Device> make(const std::string& address) override;

 private:
  Usb m_usb;
};

// The environment variable HANDWHEEL_FALCON_FIRMWARE, or handwheel/falcon.bin in the user's data folder.
std::string firmwarePath();

}  // namespace handwheel::falcon
