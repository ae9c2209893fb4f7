// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haply/Driver.h"
#include "haptics/device/DevicePlugin.h"

#include <QObject>

Q_DECLARE_INTERFACE(handwheel::DevicePlugin, HANDWHEEL_DEVICE_PLUGIN)

class HaplyPlugin : public QObject, public handwheel::DevicePlugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID HANDWHEEL_DEVICE_PLUGIN FILE "haply.json")
  Q_INTERFACES(handwheel::DevicePlugin)

 public:
  std::unique_ptr<handwheel::DeviceDriver> driver() override { return std::make_unique<handwheel::haply::Driver>(); }
};

#include "Plugin.moc"
