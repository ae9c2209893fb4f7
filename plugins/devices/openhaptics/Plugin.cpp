// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/device/DevicePlugin.h"
#include "openhaptics/Driver.h"

#include <QObject>

Q_DECLARE_INTERFACE(handwheel::DevicePlugin, HANDWHEEL_DEVICE_PLUGIN)

class OpenHapticsPlugin : public QObject, public handwheel::DevicePlugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID HANDWHEEL_DEVICE_PLUGIN FILE "openhaptics.json")
  Q_INTERFACES(handwheel::DevicePlugin)

 public:
  std::unique_ptr<handwheel::DeviceDriver> driver() override {
    return std::make_unique<handwheel::openhaptics::Driver>();
  }
};

#include "Plugin.moc"
