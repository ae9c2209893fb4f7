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

// The device drivers, both built-in and from plugins, and their devices. The catalogue must be used on one thread only.
class DeviceCatalogue {
 public:
  // Adds a built-in driver. Its id must be unique.
  void add(std::unique_ptr<DeviceDriver> driver);
  // Loads every plugin in these folders. The error of a plugin is stored in plugins() and does not prevent the loading
  // of the others.
  void load(const std::vector<std::string>& folders);

  std::vector<std::string> drivers() const;  // ids, those of built-in drivers first
  const std::vector<PluginInfo>& plugins() const { return m_plugins; }

  // Returns the connected devices of every driver.
  std::vector<DeviceInfo> find();
  // Returns the devices connected and disconnected since the last call; the first call reports every device as
  // connected. A timer calls it to support hot-plugging.
  DeviceChange poll();
  // Creates a device by the id of its driver and its address. Returns null if either is unknown.
  std::unique_ptr<Device> make(const std::string& driver, const std::string& address);

 private:
  DeviceDriver* withId(const std::string& id) const;

  std::vector<std::unique_ptr<DeviceDriver>> m_drivers;
  std::vector<PluginInfo> m_plugins;
  std::map<std::string, DeviceInfo> m_present;  // by driver and address
};

}  // namespace handwheel
