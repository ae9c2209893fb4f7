// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/PluginLoader.h"

#include <map>

namespace handwheel {

// What was plugged in and pulled out since the last look.
struct DeviceChange {
  std::vector<DeviceListing> came;
  std::vector<DeviceListing> gone;
};

// The drivers that the program has, its own and those of plugins, and the devices that they find. One thread.
class DeviceCatalogue {
 public:
  // A driver of the program itself. Its id must be new.
  void add(std::unique_ptr<DeviceDriver> driver);
  // Every plugin of these folders. What is wrong with one is kept with it, and the others are loaded all the same.
  void load(const std::vector<std::string>& folders);

  std::vector<std::string> drivers() const;  // ids, built in first
  const std::vector<PluginListing>& plugins() const { return m_plugins; }

  // Asks every driver what is plugged in.
  std::vector<DeviceListing> find();
  // The same, compared with the last call; the first finds everything new. Called by a timer, it makes hot-plugging.
  DeviceChange poll();
  // Null when the driver or the address is not known.
  std::unique_ptr<Device> make(const std::string& driver, const std::string& address);

 private:
  DeviceDriver* withId(const std::string& id) const;

  std::vector<std::unique_ptr<DeviceDriver>> m_drivers;
  std::vector<PluginListing> m_plugins;
  std::map<std::string, DeviceListing> m_present;  // by driver and address
};

}  // namespace handwheel
