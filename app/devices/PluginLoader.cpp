// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/PluginLoader.h"

#include "haptics/device/DeviceErrors.h"

#include <QDir>
#include <QJsonObject>
#include <QPluginLoader>
#include <exception>
#include <filesystem>

Q_DECLARE_INTERFACE(handwheel::DevicePlugin, HANDWHEEL_DEVICE_PLUGIN)

namespace handwheel {

namespace {

Error broken(const std::string& file, const std::string& reason) {
  return {DeviceError::PluginBroken, {reason}, {}, file};
}

// Reads the metadata in the file, before any of its code runs. An error if it is no plugin, or not one for this
// program.
std::optional<Error> readMetadata(const QPluginLoader& loader, const char* interface, PluginInfo& listing) {
  const QJsonObject metadata = loader.metaData();
  if (metadata.isEmpty()) return broken(listing.file, loader.errorString().toStdString());
  const QJsonObject own = metadata.value("MetaData").toObject();
  listing.name = own.value("name").toString().toStdString();
  listing.version = own.value("version").toString().toStdString();
  const std::string found = metadata.value("IID").toString().toStdString();
  if (found != interface) return Error{DeviceError::PluginVersion, {found, interface}, {}, listing.file};
  return {};
}

}  // namespace

QObject* loadPluginObject(const std::string& file, const char* interface, PluginInfo& listing) {
  listing.file = file;
  try {
    QPluginLoader loader(QString::fromStdString(file));
    listing.error = readMetadata(loader, interface, listing);
    if (listing.error) return nullptr;
    QObject* const object = loader.instance();
    if (!object) listing.error = broken(file, loader.errorString().toStdString());
    return object;
  } catch (const std::exception& thrown) {
    listing.error = broken(file, thrown.what());
    return nullptr;
  }
}

LoadedPlugin loadPlugin(const std::string& file) {
  LoadedPlugin result;
  QObject* const object = loadPluginObject(file, HANDWHEEL_DEVICE_PLUGIN, result.listing);
  if (!object) return result;
  try {
    auto* const plugin = qobject_cast<DevicePlugin*>(object);
    if (plugin) result.driver = plugin->driver();
    if (result.driver)
      result.listing.driver = result.driver->id();
    else
      result.listing.error = broken(file, "it brings no driver");
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
  // Commands need posts before there is an application that knows its folder.
  std::error_code ignored;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  return {(program.parent_path() / ".." / HANDWHEEL_PLUGIN_FOLDER).lexically_normal().string()};
}

}  // namespace handwheel
