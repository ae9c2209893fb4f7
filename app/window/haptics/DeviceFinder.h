// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/DeviceCatalogue.h"
#include "window/JobRunner.h"

#include <QTimer>

namespace handwheel {

// Looks on a worker for the devices that are plugged in, for asking them may take its time. Plugins are loaded with the
// first look, so a program that never uses a device never loads one. Window thread.
class DeviceFinder : public QObject {
  Q_OBJECT

 public:
  // drivers: of the program itself, besides those of plugins.
  DeviceFinder(QThreadPool& pool, std::vector<std::unique_ptr<DeviceDriver>> drivers, QObject* parent = nullptr);

  const std::vector<DeviceListing>& found() const { return m_found; }
  // What became of each plugin; empty before the first look.
  const std::vector<PluginListing>& plugins() const { return m_plugins; }
  // Looks again every two seconds.
  void setWatching(bool isOn);
  void look();
  // Makes a device, on any thread; null where it is not there. Outlives the finder.
  using Maker = std::function<std::unique_ptr<Device>()>;
  Maker maker(const std::string& driver, const std::string& address) const;

 signals:
  void looked();   // after each look
  void changed();  // and this before it, when another set was found

 private:
  struct Catalogue;
  void take(std::vector<DeviceListing> found);

  std::shared_ptr<Catalogue> m_catalogue;
  JobRunner m_jobs;
  QTimer m_timer;
  std::vector<DeviceListing> m_found;
  std::vector<PluginListing> m_plugins;
};

}  // namespace handwheel
