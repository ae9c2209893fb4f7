// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/DeviceCatalogue.h"

#include "haptics/device/DeviceErrors.h"

#include <algorithm>
#include <cassert>

namespace handwheel {

void DeviceCatalogue::add(std::unique_ptr<DeviceDriver> driver) {
  assert(driver && !withId(driver->id()));
  m_drivers.push_back(std::move(driver));
}

void DeviceCatalogue::load(const std::vector<std::string>& folders) {
  for (const std::string& folder : folders) {
    for (const std::string& file : pluginFiles(folder)) {
      LoadedPlugin loaded = loadPlugin(file);
      if (loaded.driver && withId(loaded.driver->id())) {
        loaded.listing.error =
            Error{DeviceError::PluginBroken, {"there is already a driver '" + loaded.driver->id() + "'"}, {}, file};
        loaded.listing.driver.clear();
        loaded.driver.reset();
      }
      if (loaded.driver) m_drivers.push_back(std::move(loaded.driver));
      m_plugins.push_back(std::move(loaded.listing));
    }
  }
}

std::vector<std::string> DeviceCatalogue::drivers() const {
  std::vector<std::string> ids;
  for (const auto& driver : m_drivers) ids.push_back(driver->id());
  return ids;
}

std::vector<DeviceInfo> DeviceCatalogue::find() {
  std::vector<DeviceInfo> all;
  for (const auto& driver : m_drivers) {
    std::vector<DeviceInfo> found = driver->find();
    std::move(found.begin(), found.end(), std::back_inserter(all));
  }
  return all;
}

DeviceChange DeviceCatalogue::poll() {
  std::map<std::string, DeviceInfo> now;
  DeviceChange change;
  for (DeviceInfo& listing : find()) {
    const std::string key = listing.driver + '\n' + listing.address;
    if (!m_present.contains(key)) change.came.push_back(listing);
    now.emplace(key, std::move(listing));
  }
  for (const auto& [key, listing] : m_present) {
    if (!now.contains(key)) change.gone.push_back(listing);
  }
  m_present = std::move(now);
  return change;
}

std::unique_ptr<Device> DeviceCatalogue::make(const std::string& driver, const std::string& address) {
  DeviceDriver* const known = withId(driver);
  return known ? known->make(address) : nullptr;
}

DeviceDriver* DeviceCatalogue::withId(const std::string& id) const {
  const auto found = std::find_if(m_drivers.begin(), m_drivers.end(), [&](const auto& d) { return d->id() == id; });
  return found == m_drivers.end() ? nullptr : found->get();
}

}  // namespace handwheel
