// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/HapticSession.h"

#include "haptics/device/DeviceErrors.h"
#include "haptics/device/MouseDevice.h"
#include "window/WindowServices.h"
#include "window/haptics/ActiveDevice.h"
#include "window/haptics/BuiltInDevices.h"
#include "window/haptics/DeviceMapping.h"
#include "window/haptics/DeviceMessages.h"

#include <QSettings>
#include <algorithm>

// Choosing, opening and closing of a device; HapticSessionLoop.cpp has the work with an open device.
namespace handwheel {

namespace {

constexpr int kSampleMs = 16;  // 60 a second
const auto kDriverKey = QStringLiteral("haptics/driver");
const auto kAddressKey = QStringLiteral("haptics/address");

// A device is not opened again before it is closed.
QString resourceOf(const DeviceInfo& device) {
  return QStringLiteral("device %1 %2")
      .arg(QString::fromStdString(device.driver), QString::fromStdString(device.address));
}

// Closes what nobody has taken over.
struct OpenedDevice {
  std::unique_ptr<Device> device;
  ~OpenedDevice() {
    if (device) device->close();
  }
};

}  // namespace

HapticSession::HapticSession(const Parts& parts, std::vector<std::unique_ptr<DeviceDriver>> drivers, QObject* parent)
    : QObject(parent), m_parts(parts), m_finder(parts.pool, std::move(drivers)) {
  m_timer.setInterval(kSampleMs);
  m_timer.setTimerType(Qt::PreciseTimer);
  connect(&m_timer, &QTimer::timeout, this, &HapticSession::sample);
  connect(&m_finder, &DeviceFinder::changed, this, &HapticSession::foundChanged);
  connect(&m_finder, &DeviceFinder::looked, this, &HapticSession::reportPlugins);
  connect(&m_finder, &DeviceFinder::looked, this, &HapticSession::takeUpReturned);
}

HapticSession::~HapticSession() {
  m_parts.jobs.cancelOf(this);
  if (m_open) m_open->loop->stop();
}

QList<DeviceInfo> HapticSession::found() const {
  QList<DeviceInfo> all;
  for (const DeviceInfo& listing : builtInDevices()) all << listing;
  for (const DeviceInfo& listing : m_finder.found()) all << listing;
  return all;
}

void HapticSession::setWatching(bool isOn) {
  m_isWatched = isOn;
  m_finder.setWatching(m_isWatched || m_lost);
}

void HapticSession::setLost(std::optional<DeviceStatus> how) {
  m_lost = how;
  m_isMissed = false;
  m_finder.setWatching(m_isWatched || m_lost);
}

// A device that was unplugged comes back under the same name, at another address perhaps.
std::optional<DeviceInfo> HapticSession::listingOf(const DeviceInfo& device) const {
  const auto& all = m_finder.found();
  const auto back = std::find_if(all.begin(), all.end(), [&device](const DeviceInfo& each) {
    return each.driver == device.driver && (each.address == device.address || each.name == device.name);
  });
  return back == all.end() ? std::nullopt : std::optional(*back);
}

void HapticSession::takeUpReturned() {
  if (!m_lost) return;
  if (!listingOf(m_chosen)) {
    m_isMissed = true;
  } else if (m_isMissed) {
    openAgain(m_chosen);
  }
}

void HapticSession::openAgain(const DeviceInfo& device) {
  const DeviceInfo listing = listingOf(device).value_or(device);
  choose(listing.driver, listing.address);
}

void HapticSession::choose(const std::string& driver, const std::string& address) {
  close();
  const QList<DeviceInfo> all = found();
  const auto known = std::find_if(all.begin(), all.end(), [&](const DeviceInfo& listing) {
    return listing.driver == driver && listing.address == address;
  });
  m_chosen = known != all.end() ? *known : DeviceInfo{driver, address, driver};
  if (driver != kMouseDriver) {  // at the next start the mouse is a mouse
    QSettings().setValue(kDriverKey, QString::fromStdString(driver));
    QSettings().setValue(kAddressKey, QString::fromStdString(address));
  }
  startOpening(false);
}

void HapticSession::close() {
  if (m_chosen.driver.empty()) return;
  m_parts.jobs.cancelOf(this);
  setLost({});
  closeLoop();
  m_chosen = {};
  QSettings().remove(kDriverKey);
  QSettings().remove(kAddressKey);
  emit chosenChanged();
}

void HapticSession::takeUp() {
  const std::string driver = QSettings().value(kDriverKey).toString().toStdString();
  if (driver.empty() || driver == kMouseDriver || !m_chosen.driver.empty()) return;
  m_chosen = {driver, QSettings().value(kAddressKey).toString().toStdString(), driver};
  for (const DeviceInfo& listing : found()) {
    if (listing.driver == driver && listing.address == m_chosen.address) m_chosen = listing;
  }
  startOpening(true);
}

DeviceStatus HapticSession::status() const {
  if (m_lost) return *m_lost;
  return latest() ? latest()->device.status : DeviceStatus::Starting;
}

DeviceCapabilities HapticSession::capabilities() const {
  return m_open ? m_open->capabilities : DeviceCapabilities{};
}

void HapticSession::startOpening(bool isQuiet) {
  Job job;
  job.name = tr("Opening %1").arg(nameOf(m_chosen));
  job.resource = resourceOf(m_chosen);
  job.owner = this;
  job.failed = [this, isQuiet](const Error& error) { failed(error, isQuiet); };
  job.work = [this, chosen = m_chosen, &clock = m_parts.clock, make = m_finder.maker(m_chosen.driver, m_chosen.address),
              isQuiet](Progress progress) -> Job::Finish {
    const auto made = std::make_shared<OpenedDevice>();
    std::unique_ptr<Device> device = makeBuiltIn(chosen, clock);
    if (!device) device = make();
    const Status status =
        device ? device->open(progress) : Error{DeviceError::Unreachable, {"it is not there"}, {}, {}};
    if (!status) return [this, isQuiet, error = status.error()] { failed(error, isQuiet); };
    made->device = std::move(device);
    return [this, made] { opened(std::move(made->device)); };
  };
  emit chosenChanged();
  m_parts.jobs.start(std::move(job));
}

void HapticSession::opened(std::unique_ptr<Device> device) {
  m_open = std::make_unique<ActiveDevice>();
  m_open->capabilities = device->capabilities();
  m_open->mouse = dynamic_cast<MouseDevice*>(device.get());
  m_open->hand = dynamic_cast<SimulatedDevice*>(device.get());
  m_open->ticksBefore = m_parts.services.haptics().counters().ticks;
  m_open->need = m_parts.services.needs().need(m_parts.services.haptics().id());
  m_open->loop = std::make_shared<ServoLoop>(std::move(device), m_servo, m_parts.clock, m_parts.services.haptics());
  m_open->loop->setForceOn(m_isForceOn);
  m_mapping = loadMapping(m_chosen.driver, standardMapping(m_open->capabilities));
  applyMapping(false, false);
  m_open->loop->start();
  m_rate = 0.0;
  m_rateTick = 0;
  m_rateClock.start();
  m_timer.start();
  emit chosenChanged();
  emit mappingChanged();
  emit sceneRequested();
}

// Chosen again, it is looked for anew; so what failed stays remembered for the next start.
void HapticSession::failed(const Error& error, bool isQuiet) {
  const QString name = nameOf(m_chosen);
  m_chosen = {};
  emit chosenChanged();
  if (isQuiet || error.code == ErrorCode::Cancelled) return;
  emit message(notOpenedMessage(name, error));
}

// Zero force is sent and the thread ended at once; the device may take its time to close.
void HapticSession::closeLoop() {
  if (!m_open) return;
  m_timer.stop();
  m_testEnd.reset();
  m_open->loop->stop();
  stopRecording();
  Job job;
  job.name = tr("Closing %1").arg(nameOf(m_chosen));
  job.resource = resourceOf(m_chosen);
  job.work = [loop = std::exchange(m_open->loop, nullptr)](Progress) mutable -> Job::Finish {
    loop.reset();
    return {};
  };
  m_open.reset();
  m_parts.jobs.start(std::move(job));
}

void HapticSession::reportPlugins() {
  const std::vector<PluginInfo>& all = m_finder.plugins();
  for (; m_pluginsReported < all.size(); ++m_pluginsReported) {
    if (all[m_pluginsReported].error) emit message(unusedPluginMessage(all[m_pluginsReported]));
  }
}

}  // namespace handwheel
