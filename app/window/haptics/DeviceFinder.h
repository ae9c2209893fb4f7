// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/DeviceCatalogue.h"
#include "window/JobRunner.h"

#include <QTimer>

namespace handwheel {

// Searches for connected devices on a worker thread, because querying them may be slow. The first search loads the
// plugins, so a program that never uses a device never loads one. Window thread.
class DeviceFinder : public QObject {
  Q_OBJECT

 public:
  // drivers: the built-in ones, in addition to those of plugins.
  DeviceFinder(QThreadPool& pool, std::vector<std::unique_ptr<DeviceDriver>> drivers, QObject* parent = nullptr);

  const std::vector<DeviceInfo>& found() const { return m_found; }
  // The result of loading each plugin; empty before the first search.
  const std::vector<PluginInfo>& plugins() const { return m_plugins; }
  // Switches a repeated search every two seconds.
  void setWatching(bool isOn);
  void look();
  // Creates a device, on any thread; null if it is not connected. May outlive the finder.
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
