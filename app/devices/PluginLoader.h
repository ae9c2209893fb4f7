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
  std::string name;     // from the metadata of the plugin; empty if they have no readable name
  std::string version;  // version of the plugin itself
  std::string driver;   // id of its driver; empty if loading failed
  std::optional<Error> error;
};

// Loads a plugin and returns its root object, or null after setting listing.error if the plugin cannot be used. Reads
// the metadata first, and loads no code of a plugin that was made for another version of the interface. Plugins are
// never unloaded. Errors: PluginVersion, PluginBroken.
QObject* loadPluginObject(const std::string& file, const char* interface, PluginInfo& listing);

// The result of loading a device plugin.
struct LoadedPlugin {
  PluginInfo listing;
  std::unique_ptr<DeviceDriver> driver;  // null if loading failed
};

// Loads a device plugin and creates its driver. The errors are those of loadPluginObject(), in listing.error.
LoadedPlugin loadPlugin(const std::string& file);

// Returns the shared libraries in a folder, sorted. The list is empty if there is no such folder.
std::vector<std::string> pluginFiles(const std::string& folder);

// Returns the folders that are searched for plugins. They are the folders in the environment variable
// HANDWHEEL_PLUGINS, separated by colons; without this variable, the plugin folder of this program. A QCoreApplication
// must exist.
std::vector<std::string> pluginFolders();

}  // namespace handwheel
