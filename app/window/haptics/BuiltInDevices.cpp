// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/BuiltInDevices.h"

#include "haptics/device/MouseDevice.h"
#include "haptics/device/SimulatedDevice.h"

#include <QCoreApplication>

namespace handwheel {

namespace {

struct BuiltInDevicesWords {
  Q_DECLARE_TR_FUNCTIONS(HapticSession)
};

constexpr const char* kMouse = "mouse";

}  // namespace

std::vector<DeviceInfo> builtInDevices() {
  return {{kSimulatedDriver, kSimulatedAddress, BuiltInDevicesWords::tr("Simulated hand").toStdString()},
          {kMouse, "pointer", BuiltInDevicesWords::tr("Mouse as device").toStdString()}};
}

std::unique_ptr<Device> makeBuiltIn(const std::string& driver, ServoClock& clock) {
  if (driver == kMouse) return std::make_unique<MouseDevice>();
  if (driver == kSimulatedDriver) return std::make_unique<SimulatedDevice>(simulatedDevice(), PoseTrajectory(), clock);
  return nullptr;
}

}  // namespace handwheel
