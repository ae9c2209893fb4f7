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

constexpr const char* kTurnedAddress = "turned-hand";  // address of the simulated device with motors for torque

}  // namespace

std::vector<DeviceInfo> builtInDevices() {
  return {{kSimulatedDriver, kSimulatedAddress, BuiltInDevicesWords::tr("Simulated hand").toStdString()},
          {kSimulatedDriver, kTurnedAddress, BuiltInDevicesWords::tr("Simulated hand with torque").toStdString()},
          {kMouseDriver, "pointer", BuiltInDevicesWords::tr("Mouse as device").toStdString()}};
}

std::unique_ptr<Device> makeBuiltIn(const DeviceInfo& listing, ServoClock& clock) {
  if (listing.driver == kMouseDriver) return std::make_unique<MouseDevice>();
  if (listing.driver != kSimulatedDriver) return nullptr;
  const bool hasTorque = listing.address == kTurnedAddress;
  return std::make_unique<SimulatedDevice>(hasTorque ? simulatedTorqueDevice() : simulatedDevice(), PoseTrajectory(),
                                           clock);
}

}  // namespace handwheel
