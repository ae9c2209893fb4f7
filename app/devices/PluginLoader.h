// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/DevicePlugin.h"

#include <optional>
#include <string>

class QObject;

namespace handwheel {

// A plugin that was found, with the error if it cannot be used.
struct PluginInfo {
  std::string file;
  std::string name;     // from its metadata; empty if that has no readable name
  std::string version;  // version of the plugin itself
  std::string driver;   // id of its driver; empty if loading failed
  std::optional<Error> error;
};

// Loads a plugin and returns its root object. Reads the metadata first, and loads no code of a plugin that was made for
// another version of the interface. Returns null if it cannot be used, and sets listing.error. Never unloads. Errors:
// PluginVersion, PluginBroken.
QObject* loadPluginObject(const std::string& file, const char* interface, PluginInfo& listing);

// The result of loading a plugin of devices.
struct LoadedPlugin {
  PluginInfo listing;
  std::unique_ptr<DeviceDriver> driver;  // null if loading failed
};

// Loads a plugin of devices and creates its driver. Errors: those of loadPluginObject().
LoadedPlugin loadPlugin(const std::string& file);

// Returns the shared libraries in a folder, sorted; none if there is no such folder.
std::vector<std::string> pluginFiles(const std::string& folder);

// Returns the folders that are searched for plugins: those in the environment variable HANDWHEEL_PLUGINS, separated by
// colons; without it, the one that belongs to this program. Needs a QCoreApplication.
std::vector<std::string> pluginFolders();

}  // namespace handwheel
