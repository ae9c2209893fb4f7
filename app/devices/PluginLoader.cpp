// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/PluginLoader.h"

#include "haptics/device/DeviceErrors.h"

#include <QCoreApplication>
#include <QDir>
#include <QJsonObject>
#include <QPluginLoader>
#include <exception>

Q_DECLARE_INTERFACE(handwheel::DevicePlugin, HANDWHEEL_DEVICE_PLUGIN)

namespace handwheel {

namespace {

Error broken(const std::string& file, const std::string& reason) {
  return {DeviceError::PluginBroken, {reason}, {}, file};
}

// What stands in the file, before any of its code runs. An error when it is no plugin, or not one for this program.
std::optional<Error> readMetadata(const QPluginLoader& loader, PluginInfo& listing) {
  const QJsonObject metadata = loader.metaData();
  if (metadata.isEmpty()) return broken(listing.file, loader.errorString().toStdString());
  const QJsonObject own = metadata.value("MetaData").toObject();
  listing.name = own.value("name").toString().toStdString();
  listing.version = own.value("version").toString().toStdString();
  const std::string interface = metadata.value("IID").toString().toStdString();
  if (interface != HANDWHEEL_DEVICE_PLUGIN) {
    return Error{DeviceError::PluginVersion, {interface, HANDWHEEL_DEVICE_PLUGIN}, {}, listing.file};
  }
  return {};
}

// The driver of a plugin whose metadata is right, or null and why.
std::unique_ptr<DeviceDriver> makeDriver(QPluginLoader& loader, PluginInfo& listing) {
  auto* const plugin = qobject_cast<DevicePlugin*>(loader.instance());
  if (!plugin) {
    listing.error = broken(listing.file, loader.errorString().toStdString());
    return nullptr;
  }
  std::unique_ptr<DeviceDriver> driver = plugin->driver();
  if (driver) {
    listing.driver = driver->id();
  } else {
    listing.error = broken(listing.file, "it brings no driver");
  }
  return driver;
}

}  // namespace

LoadedPlugin loadPlugin(const std::string& file) {
  LoadedPlugin result;
  result.listing.file = file;
  try {
    QPluginLoader loader(QString::fromStdString(file));
    result.listing.error = readMetadata(loader, result.listing);
    if (!result.listing.error) result.driver = makeDriver(loader, result.listing);
  } catch (const std::exception& thrown) {
    result.listing.error = broken(file, thrown.what());
  }
  return result;
}

std::vector<std::string> pluginFiles(const std::string& folder) {
  std::vector<std::string> files;
  const QDir directory(QString::fromStdString(folder));
  for (const QString& name : directory.entryList({"*.so"}, QDir::Files, QDir::Name)) {
    files.push_back(directory.filePath(name).toStdString());
  }
  return files;
}

std::vector<std::string> pluginFolders() {
  std::vector<std::string> folders;
  if (qEnvironmentVariableIsSet("HANDWHEEL_PLUGINS")) {
    for (const QString& folder : qEnvironmentVariable("HANDWHEEL_PLUGINS").split(':', Qt::SkipEmptyParts)) {
      folders.push_back(folder.toStdString());
    }
    return folders;
  }
  const QString own = QCoreApplication::applicationDirPath() + "/../" HANDWHEEL_PLUGIN_FOLDER;
  return {QDir::cleanPath(own).toStdString()};
}

}  // namespace handwheel
