// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "example/Driver.h"
#include "haptics/device/DevicePlugin.h"

#include <QObject>

Q_DECLARE_INTERFACE(handwheel::DevicePlugin, HANDWHEEL_DEVICE_PLUGIN)

class ExamplePlugin : public QObject, public handwheel::DevicePlugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID HANDWHEEL_DEVICE_PLUGIN FILE "example.json")
  Q_INTERFACES(handwheel::DevicePlugin)

 public:
  std::unique_ptr<handwheel::DeviceDriver> driver() override { return std::make_unique<handwheel::ExampleDriver>(); }
};

#include "Plugin.moc"
