// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/DeviceCatalogue.h"
#include "window/JobRunner.h"

#include <QTimer>

namespace handwheel {

// Searches for connected devices on a worker thread, because querying them may be slow. The first search loads the
// plugins, so a program that never uses a device never loads one. Must be used on the window thread.
class DeviceFinder : public QObject {
  Q_OBJECT

 public:
  // drivers: the built-in drivers, in addition to those of plugins.
  DeviceFinder(QThreadPool& pool, std::vector<std::unique_ptr<DeviceDriver>> drivers, QObject* parent = nullptr);

  const std::vector<DeviceInfo>& found() const { return m_found; }
  // The result of loading each plugin; empty before the first search.
  const std::vector<PluginInfo>& plugins() const { return m_plugins; }
  // Switches a repeated search, every two seconds, on or off.
  void setWatching(bool isOn);
  void look();
  // A function that creates a device; it returns null if the device is not connected. It may be called on any thread,
  // and may outlive the finder.
  using Maker = std::function<std::unique_ptr<Device>()>;
  Maker maker(const std::string& driver, const std::string& address) const;

 signals:
  void looked();   // emitted after each search
  void changed();  // emitted before looked(), if the set of devices has changed

 private:
  struct Catalogue;
  void take(std::vector<DeviceInfo> found);

  std::shared_ptr<Catalogue> m_catalogue;
  JobRunner m_jobs;
  QTimer m_timer;
  std::vector<DeviceInfo> m_found;
  std::vector<PluginInfo> m_plugins;
};

}  // namespace handwheel
