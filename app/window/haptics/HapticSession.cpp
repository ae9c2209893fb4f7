// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/HapticSession.h"

#include "haptics/ForceRecorder.h"
#include "haptics/ForceTest.h"
#include "haptics/MouseDevice.h"
#include "window/WindowServices.h"
#include "window/haptics/BuiltInDevices.h"
#include "window/haptics/DeviceMapping.h"
#include "window/haptics/DeviceMessages.h"

#include <QSettings>
#include <algorithm>

namespace handwheel {

namespace {

constexpr int kSampleMs = 16;          // 60 a second
constexpr int kRateMs = 500;           // over which the rate is measured
constexpr double kTestTail = 0.2;      // s after the last pull, for what the safety chain has delayed
constexpr double kLetGo = 0.02;        // N: a force that may break off unnoticed
constexpr double kLongestWait = 0.25;  // s for it: what damps a moving hand may stay
const auto kDriverKey = QStringLiteral("haptics/driver");
const auto kAddressKey = QStringLiteral("haptics/address");

// Closes what nobody has taken over.
struct OpenedDevice {
  std::unique_ptr<Device> device;
  ~OpenedDevice() {
    if (device) device->close();
  }
};

QString nameOf(const DeviceListing& listing) {
  return QString::fromStdString(listing.name.empty() ? listing.driver : listing.name);
}

}  // namespace

struct HapticSession::OpenDevice {
  DeviceCapabilities capabilities;
  MouseDevice* mouse = nullptr;  // of the loop, when it is that
  SimulatedDevice* hand = nullptr;
  Need need;
  std::uint64_t ticksBefore = 0;  // that the service had counted
  std::shared_ptr<ServoLoop> loop;
  std::unique_ptr<ForceRecorder> recorder;  // goes before its loop
  std::optional<ServoSample> sample;
  std::optional<double> isChangingSince;  // s by the clock of the loop: its settings
};

HapticSession::HapticSession(const Parts& parts, std::vector<std::unique_ptr<DeviceDriver>> drivers, QObject* parent)
    : QObject(parent), m_parts(parts), m_finder(parts.pool, std::move(drivers)) {
  m_timer.setInterval(kSampleMs);
  m_timer.setTimerType(Qt::PreciseTimer);
  connect(&m_timer, &QTimer::timeout, this, &HapticSession::sample);
  connect(&m_finder, &DeviceFinder::changed, this, &HapticSession::foundChanged);
  connect(&m_finder, &DeviceFinder::looked, this, &HapticSession::tellPlugins);
}

HapticSession::~HapticSession() {
  m_parts.jobs.cancelOf(this);
  if (m_open) m_open->loop->stop();
}

QList<DeviceListing> HapticSession::found() const {
  QList<DeviceListing> all;
  for (const DeviceListing& listing : builtInDevices()) all << listing;
  for (const DeviceListing& listing : m_finder.found()) all << listing;
  return all;
}

void HapticSession::choose(const std::string& driver, const std::string& address) {
  close();
  const QList<DeviceListing> all = found();
  const auto known = std::find_if(all.begin(), all.end(), [&](const DeviceListing& listing) {
    return listing.driver == driver && listing.address == address;
  });
  m_chosen = known != all.end() ? *known : DeviceListing{driver, address, driver};
  QSettings().setValue(kDriverKey, QString::fromStdString(driver));
  QSettings().setValue(kAddressKey, QString::fromStdString(address));
  startOpening(false);
}

void HapticSession::close() {
  if (m_chosen.driver.empty()) return;
  m_parts.jobs.cancelOf(this);
  closeLoop();
  m_chosen = {};
  QSettings().remove(kDriverKey);
  QSettings().remove(kAddressKey);
  emit chosenChanged();
}

void HapticSession::takeUp() {
  const std::string driver = QSettings().value(kDriverKey).toString().toStdString();
  if (driver.empty() || !m_chosen.driver.empty()) return;
  m_chosen = {driver, QSettings().value(kAddressKey).toString().toStdString(), driver};
  for (const DeviceListing& listing : found()) {
    if (listing.driver == driver && listing.address == m_chosen.address) m_chosen = listing;
  }
  startOpening(true);
}

DeviceCapabilities HapticSession::capabilities() const {
  return m_open ? m_open->capabilities : DeviceCapabilities{};
}

void HapticSession::startOpening(bool isQuiet) {
  Job job;
  job.name = tr("Opening %1").arg(nameOf(m_chosen));
  job.owner = this;
  job.failed = [this, isQuiet](const Error& error) { failed(error, isQuiet); };
  job.work = [this, chosen = m_chosen, &clock = m_parts.clock, make = m_finder.maker(m_chosen.driver, m_chosen.address),
              isQuiet](Progress progress) -> Job::Finish {
    const auto made = std::make_shared<OpenedDevice>();
    std::unique_ptr<Device> device = makeBuiltIn(chosen.driver, clock);
    if (!device) device = make();
    const Status status =
        device ? device->open(progress) : Error{ErrorCode::DeviceUnreachable, {"it is not there"}, {}, {}};
    if (!status) return [this, isQuiet, error = status.error()] { failed(error, isQuiet); };
    made->device = std::move(device);
    return [this, made] { opened(std::move(made->device)); };
  };
  emit chosenChanged();
  m_parts.jobs.start(std::move(job));
}

void HapticSession::opened(std::unique_ptr<Device> device) {
  m_open = std::make_unique<OpenDevice>();
  m_open->capabilities = device->capabilities();
  m_open->mouse = dynamic_cast<MouseDevice*>(device.get());
  m_open->hand = dynamic_cast<SimulatedDevice*>(device.get());
  m_open->ticksBefore = m_parts.services.haptics().counters().ticks;
  m_open->need = m_parts.services.needs().need(m_parts.services.haptics().id());
  m_open->loop = std::make_shared<ServoLoop>(std::move(device), m_servo, m_parts.clock, m_parts.services.haptics());
  m_open->loop->setForceOn(m_isForceOn);
  m_mapping = keptMapping(m_chosen.driver, standardMapping(m_open->capabilities));
  applyMapping(false);
  m_open->loop->start();
  m_rate = 0.0;
  m_rateTick = 0;
  m_rateClock.start();
  m_timer.start();
  emit chosenChanged();
  emit mappingChanged();
  emit sceneWanted();
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
  job.work = [loop = std::exchange(m_open->loop, nullptr)](Progress) mutable -> Job::Finish {
    loop.reset();
    return {};
  };
  m_open.reset();
  m_parts.jobs.start(std::move(job));
}

void HapticSession::startRecording() {
  if (!m_open || m_open->recorder) return;
  m_open->recorder = std::make_unique<ForceRecorder>(*m_open->loop);
  m_open->recorder->start();
  emit recordingStarted();
}

void HapticSession::stopRecording() {
  if (!m_open || !m_open->recorder) return;
  const auto recorder = std::move(m_open->recorder);
  recorder->stop();
  emit recorded(recorder->recording(), nameOf(m_chosen), m_open->capabilities.maxForce / mappingInScene().forceGain);
}

const ForceRecorder* HapticSession::recorder() const {
  return m_open ? m_open->recorder.get() : nullptr;
}

void HapticSession::mark(const QString& event) {
  if (m_open && m_open->recorder) m_open->recorder->mark(event.toStdString());
}

const ServoSample* HapticSession::latest() const {
  return m_open && m_open->sample ? &*m_open->sample : nullptr;
}

const LoopMeasure* HapticSession::measure() const {
  return m_open ? &m_open->loop->measure() : nullptr;
}

RealTimeState HapticSession::realTime() const {
  return m_open ? m_open->loop->realTime() : RealTimeState::NotRunning;
}

std::uint64_t HapticSession::missedTicks() const {
  return m_open ? m_open->loop->missedTicks() : 0;
}

void HapticSession::setMapping(const WorkspaceMapping& mapping) {
  m_mapping = mapping;
  if (!m_open) return;
  keepMapping(m_chosen.driver, mapping);
  applyMapping(true);
  announceLeap();  // with other axes or another scale the force turns about
  emit mappingChanged();
}

void HapticSession::setView(const CameraState& camera, const Box& model, const std::optional<Vec3>& seen) {
  m_camera = camera;
  m_model = model;
  m_seen = seen;
  if (!m_open) return;
  const ServoSample* const last = latest();
  applyMapping(last && isInView(camera, last->tip.position));
}

void HapticSession::recentre() {
  applyMapping(false);
}

// The mouse points in the scene itself.
WorkspaceMapping HapticSession::mappingInScene() const {
  if (!m_open || m_open->mouse) return {};
  return mappingInView(m_mapping, m_open->capabilities, m_camera, m_model, m_seen);
}

void HapticSession::applyMapping(bool keepsTip) {
  if (!m_open) return;
  WorkspaceMapping mapping = mappingInScene();
  mapping.keepsTip = keepsTip && !m_open->mouse;
  emit viewChanged();
  m_open->loop->setMapping(mapping);
}

void HapticSession::setTouch(const TouchSettings& touch) {
  if (touch == m_touch) return;
  m_touch = touch;
  keepTouch(touch);
  emit touchChanged();
}

void HapticSession::setForceOn(bool isOn) {
  if (isOn == m_isForceOn) return;
  m_isForceOn = isOn;
  if (m_open && !m_open->isChangingSince) m_open->loop->setForceOn(isOn);
  emit forceOnChanged(isOn);
}

// A force that broke off in contact would be felt as a blow: it goes first.
void HapticSession::setServo(const ServoSettings& servo) {
  if (servo == m_servo) return;
  m_servo = servo;
  if (!m_open || m_open->isChangingSince) return;
  m_open->isChangingSince = latest() ? latest()->tip.time : 0.0;
  m_open->loop->setForceOn(false);
}

void HapticSession::changeServo() {
  const ServoSample& last = *m_open->sample;
  if (last.sent.force.norm() > kLetGo && last.tip.time < *m_open->isChangingSince + kLongestWait) return;
  m_open->isChangingSince.reset();
  m_open->loop->stop();
  m_open->loop->setSettings(m_servo);
  m_open->loop->setForceOn(m_isForceOn);
  m_open->loop->start();
}

void HapticSession::startForceTest() {
  if (!latest()) return;
  auto scene = std::make_unique<HapticScene>();
  scene->source = std::make_unique<ForceTest>(kTestForce, mappingInScene());
  m_open->loop->setScene(std::move(scene));
  m_testEnd = latest()->tip.time + ForceTest::kDuration + kTestTail;
}

void HapticSession::setScene(std::unique_ptr<HapticScene> scene) {
  if (m_open && !m_testEnd) m_open->loop->setScene(std::move(scene));
}

void HapticSession::announceLeap() {
  if (m_open) m_open->loop->announceLeap();
}

MouseDevice* HapticSession::mouse() const {
  return m_open ? m_open->mouse : nullptr;
}

SimulatedDevice* HapticSession::simulatedHand() const {
  return m_open ? m_open->hand : nullptr;
}

void HapticSession::sample() {
  m_open->loop->collect();
  // Before the first tick the channel holds a sample that nobody has made.
  if (m_parts.services.haptics().counters().ticks == m_open->ticksBefore) return;
  const DeviceStatus before = m_open->sample ? m_open->sample->device.status : DeviceStatus::Starting;
  m_open->sample = m_open->loop->latest();
  measureRate();
  if (m_open->sample->device.status != before) tellStatus(m_open->sample->device.status);
  if (m_open->recorder && m_open->recorder->isFull()) stopRecording();
  if (m_testEnd && m_open->sample->tip.time > *m_testEnd) endForceTest();
  if (m_open->isChangingSince) changeServo();
  emit sampled();
}

void HapticSession::endForceTest() {
  m_testEnd.reset();
  setScene(std::make_unique<HapticScene>());
  emit sceneWanted();
}

void HapticSession::measureRate() {
  if (m_rateClock.elapsed() < kRateMs) return;
  const std::uint64_t tick = m_open->sample->tick;
  m_rate = 1e3 * static_cast<double>(tick - m_rateTick) / static_cast<double>(m_rateClock.restart());
  m_rateTick = tick;
}

void HapticSession::tellStatus(DeviceStatus status) {
  if (m_open->mouse || (status != DeviceStatus::Absent && status != DeviceStatus::Failed)) return;
  emit message(lostMessage(nameOf(m_chosen), status));
}

void HapticSession::tellPlugins() {
  const std::vector<PluginListing>& all = m_finder.plugins();
  for (; m_pluginsTold < all.size(); ++m_pluginsTold) {
    if (all[m_pluginsTold].error) emit message(unusedPluginMessage(all[m_pluginsTold]));
  }
}

}  // namespace handwheel
