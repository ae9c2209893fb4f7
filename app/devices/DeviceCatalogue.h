// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/PluginLoader.h"

#include <map>

namespace handwheel {

// The devices connected and disconnected since the last poll.
struct DeviceChange {
  std::vector<DeviceInfo> came;
  std::vector<DeviceInfo> gone;
};

// The device drivers, built in and from plugins, and the devices they find. One thread.
class DeviceCatalogue {
 public:
  // Adds a built-in driver. Its id must be unique.
  void add(std::unique_ptr<DeviceDriver> driver);
  // Loads every plugin in these folders. An error is kept with its plugin; the others are loaded nevertheless.
  void load(const std::vector<std::string>& folders);

  std::vector<std::string> drivers() const;  // ids, built in first
  const std::vector<PluginInfo>& plugins() const { return m_plugins; }

  // Asks every driver for the connected devices.
  std::vector<DeviceInfo> find();
  // Compares the connected devices with those of the last call; the first call reports every device as new. Called by a
  // timer for hot-plugging.
  DeviceChange poll();
  // Creates a device. Returns null if the driver or the address is not known.
  std::unique_ptr<Device> make(const std::string& driver, const std::string& address);

 private:
  DeviceDriver* withId(const std::string& id) const;

  std::vector<std::unique_ptr<DeviceDriver>> m_drivers;
  std::vector<PluginInfo> m_plugins;
  std::map<std::string, DeviceInfo> m_present;  // by driver and address
};

}  // namespace handwheel
