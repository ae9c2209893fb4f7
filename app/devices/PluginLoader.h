// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/DevicePlugin.h"

#include <optional>
#include <string>

namespace handwheel {

// A plugin that was found, and why it is not used if it is not.
struct PluginListing {
  std::string file;
  std::string name;     // from its metadata; empty where it has none that can be read
  std::string version;  // of the plugin itself
  std::string driver;   // which it brought; empty when it failed
  std::optional<Error> error;
};

struct LoadedPlugin {
  PluginListing listing;
  std::unique_ptr<DeviceDriver> driver;  // null when it failed
};

// Reads the metadata first, and loads no code of a plugin that was made for another interface. Never unloads.
// Errors: PluginVersion, PluginBroken.
LoadedPlugin loadPlugin(const std::string& file);

// The libraries in a folder, sorted; none when there is no such folder.
std::vector<std::string> pluginFiles(const std::string& folder);

// Where plugins are looked for: the folders that the environment variable HANDWHEEL_PLUGINS names, separated by colons;
// without it, the one that belongs to this program. Needs a QCoreApplication.
std::vector<std::string> pluginFolders();

}  // namespace handwheel
