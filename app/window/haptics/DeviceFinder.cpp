// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/DeviceFinder.h"

#include <algorithm>
#include <mutex>

namespace handwheel {

namespace {

constexpr int kFindLookMs = 2000;

bool isSame(const DeviceInfo& a, const DeviceInfo& b) {
  return a.driver == b.driver && a.address == b.address && a.name == b.name;
}

}  // namespace

// A look and the making of a device may come together from two workers, and a catalogue takes one thread at a time.
struct DeviceFinder::Catalogue {
  std::mutex mutex;
  DeviceCatalogue devices;
  bool isLoaded = false;

  void load() {
    if (!isLoaded) devices.load(pluginFolders());
    isLoaded = true;
  }
};

DeviceFinder::DeviceFinder(QThreadPool& pool, std::vector<std::unique_ptr<DeviceDriver>> drivers, QObject* parent)
    : QObject(parent), m_catalogue(std::make_shared<Catalogue>()), m_jobs(JobRunner::Policy::Latest, pool) {
  for (std::unique_ptr<DeviceDriver>& driver : drivers) m_catalogue->devices.add(std::move(driver));
  m_timer.setInterval(kFindLookMs);
  connect(&m_timer, &QTimer::timeout, this, [this] {
    if (m_jobs.isIdle()) look();
  });
}

void DeviceFinder::setWatching(bool isOn) {
  if (isOn == m_timer.isActive()) return;
  isOn ? m_timer.start() : m_timer.stop();
  if (isOn) look();
}

void DeviceFinder::look() {
  Job job;
  job.name = tr("Looking for devices");
  job.work = [this, catalogue = m_catalogue](Progress) -> Job::Finish {
    const std::lock_guard lock(catalogue->mutex);
    catalogue->load();
    return [this, found = catalogue->devices.find(), plugins = catalogue->devices.plugins()] {
      m_plugins = plugins;
      take(found);
    };
  };
  m_jobs.start(std::move(job));
}

DeviceFinder::Maker DeviceFinder::maker(const std::string& driver, const std::string& address) const {
  return [catalogue = m_catalogue, driver, address] {
    const std::lock_guard lock(catalogue->mutex);
    catalogue->load();
    return catalogue->devices.make(driver, address);
  };
}

void DeviceFinder::take(std::vector<DeviceInfo> found) {
  if (!std::equal(found.begin(), found.end(), m_found.begin(), m_found.end(), isSame)) {
    m_found = std::move(found);
    emit changed();
  }
  emit looked();
}

}  // namespace handwheel
