// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/SpaceMouseNavigation.h"

#include "viewport/Viewport.h"
#include "window/haptics/DeviceMapping.h"
#include "window/haptics/DeviceMessages.h"
#include "window/haptics/HapticSession.h"

#include <QDir>
#include <algorithm>

namespace handwheel {

namespace {

constexpr int kMoveMs = 16;           // 60 a second
constexpr int kSettlingMs = 1000;     // from a new node to its permissions
constexpr int kTries = 2;             // number of attempts to open one: the permissions may be set later still
constexpr double kLongestStep = 0.1;  // s: a window that was busy does not leap
constexpr double kShiftSpeed = 1.0;   // heights of the view in a second at full deflection; enlarging by e
constexpr double kTurnSpeed = 1.6;    // rad/s for a tilt of 1

std::string keyOf(const DeviceInfo& listing) {
  return listing.driver + '\n' + listing.address;
}

}  // namespace

SpaceMouseNavigation::SpaceMouseNavigation(HapticSession& session, Viewport& viewport, QThreadPool& pool,
                                           QObject* parent)
    : QObject(parent), m_session(session), m_viewport(viewport), m_jobs(JobRunner::Policy::Queue, pool) {
  m_settling.setSingleShot(true);
  m_settling.setInterval(kSettlingMs);
  m_timer.setInterval(kMoveMs);
  connect(&m_folders, &QFileSystemWatcher::directoryChanged, this, &SpaceMouseNavigation::readNodes);
  connect(&m_settling, &QTimer::timeout, this, [this] { m_session.finder().look(); });
  connect(&m_timer, &QTimer::timeout, this, &SpaceMouseNavigation::move);
  connect(&session.finder(), &DeviceFinder::looked, this, &SpaceMouseNavigation::followList);
  connect(&session, &HapticSession::chosenChanged, this, &SpaceMouseNavigation::followChoice);
}

SpaceMouseNavigation::~SpaceMouseNavigation() {
  m_jobs.cancelAll();
}

void SpaceMouseNavigation::watch(const QStringList& folders) {
  for (const QString& folder : folders)
    if (QDir(folder).exists()) m_folders.addPath(folder);
  readNodes();
  if (!m_settling.isActive()) return;
  m_settling.stop();  // those that were there before the program have their permissions
  m_session.finder().look();
}

void SpaceMouseNavigation::readNodes() {
  QStringList nodes;
  for (const QString& folder : m_folders.directories())
    nodes +=
        QDir(folder).entryList({QStringLiteral("hidraw*"), QStringLiteral("spnav.sock")}, QDir::Files | QDir::System);
  if (std::exchange(m_nodes, nodes) != nodes) m_settling.start();
}

void SpaceMouseNavigation::setMotion(bool isOn, double speed) {
  m_isOn = isOn;
  m_speed = speed;
}

std::vector<std::string> SpaceMouseNavigation::names() const {
  std::vector<std::string> all;
  for (const OpenDevice& device : m_devices) all.push_back(device.listing.name);
  return all;
}

bool SpaceMouseNavigation::isChosen(const DeviceInfo& listing) const {
  return keyOf(m_session.chosen()) == keyOf(listing);
}

template <class IsMeant>
void SpaceMouseNavigation::drop(IsMeant isMeant) {
  const bool isAny = std::erase_if(m_devices, [&](const OpenDevice& device) {
                       if (!isMeant(device)) return false;
                       m_tries.erase(keyOf(device.listing));
                       return true;
                     }) > 0;
  if (m_devices.empty()) m_timer.stop();
  if (isAny) emit changed();
}

// A disconnected device may return; when spacenavd starts, the devices themselves disappear.
void SpaceMouseNavigation::followList() {
  if (m_folders.directories().isEmpty()) return;
  const std::vector<DeviceInfo>& found = m_session.finder().found();
  const auto isThere = [&](const std::string& key) {
    return std::any_of(found.begin(), found.end(), [&](const DeviceInfo& each) { return keyOf(each) == key; });
  };
  drop([&](const OpenDevice& device) { return !isThere(keyOf(device.listing)); });
  std::erase_if(m_tries, [&](const auto& tried) { return !isThere(tried.first); });
  for (const DeviceInfo& listing : found) {
    if (!isChosen(listing) && !m_tries.contains(keyOf(listing))) tryOpening(listing);
  }
}

void SpaceMouseNavigation::followChoice() {
  drop([this](const OpenDevice& device) { return isChosen(device.listing); });
  m_tries.erase(keyOf(m_session.chosen()));
  followList();
}

// The type of a device is known once it is made, before it is open.
void SpaceMouseNavigation::tryOpening(const DeviceInfo& listing) {
  ++m_tries[keyOf(listing)];
  Job job;
  job.name = tr("Opening %1").arg(QString::fromStdString(listing.name));
  job.work = [this, listing,
              make = m_session.finder().maker(listing.driver, listing.address)](Progress progress) -> Job::Finish {
    const std::shared_ptr<Device> device = make();
    if (!device || !device->capabilities().isRateControl) return {};
    const Status status = device->open(progress);
    if (!status) return [this, listing, error = status.error()] { failed(listing, error); };
    return [this, listing, device] { opened(listing, device); };
  };
  m_jobs.start(std::move(job));
}

void SpaceMouseNavigation::opened(const DeviceInfo& listing, std::shared_ptr<Device> device) {
  if (isChosen(listing)) return;
  const DeviceCapabilities all = device->capabilities();
  m_devices.push_back({listing, std::move(device), loadMapping(listing.driver, standardMapping(all)),
                       std::max(all.workspaceRadius, 1e-3)});
  m_sinceMove.start();
  m_timer.start();
  emit changed();
}

void SpaceMouseNavigation::failed(const DeviceInfo& listing, const Error& error) {
  if (m_tries[keyOf(listing)] >= kTries) {
    emit message(notOpenedMessage(QString::fromStdString(listing.name), error));
    return;
  }
  QTimer::singleShot(kSettlingMs, this, [this, listing] {
    if (m_tries.contains(keyOf(listing)) && !isChosen(listing)) tryOpening(listing);
  });
}

// Other programs get the same reports: only the window that is in use follows them.
void SpaceMouseNavigation::move() {
  const double seconds = std::min(1e-3 * static_cast<double>(m_sinceMove.restart()), kLongestStep);
  const Motion now = motion();
  if (now.isRest() || !m_isOn || !m_viewport.isVisible() || !m_viewport.window()->isActiveWindow())
    return m_pivot.reset();
  if (m_taker) {
    m_taker(m_viewport.camera().orientation * Vec3(m_speed * seconds * now.shift));
    return;
  }
  if (!m_pivot) m_pivot = pivot();
  m_viewport.moveByHand(*m_pivot, m_speed * seconds * now.shift, m_speed * seconds * now.turn);
}

SpaceMouseNavigation::Motion SpaceMouseNavigation::motion() {
  Motion sum;
  bool isAnyGone = false;
  for (const OpenDevice& device : m_devices) {
    const DeviceState state = device.device->read();
    isAnyGone |= state.status == DeviceStatus::Absent;
    if (state.status != DeviceStatus::Ready) continue;
    const Eigen::Matrix3d axes = device.mapping.viewFromDevice();
    const Eigen::AngleAxisd tilt(state.orientation);
    sum.shift += kShiftSpeed / device.reach * (axes * outsideDeadZone(state.position, device.mapping.deadZone));
    sum.turn += kTurnSpeed * axes.determinant() *
                (axes * outsideDeadZone(tilt.angle() * tilt.axis(), device.mapping.angularDeadZone));
  }
  if (isAnyGone) {
    drop([](const OpenDevice& device) { return device.device->read().status == DeviceStatus::Absent; });
    m_settling.start();  // not at once: one that is there, but does not answer, would be opened again and again
  }
  return sum;
}

// Returns the surface point in the middle of the view, or else the middle of the model.
Vec3 SpaceMouseNavigation::pivot() const {
  const QPointF middle(0.5 * m_viewport.width(), 0.5 * m_viewport.height());
  const Pick pick = m_viewport.pickAt(middle);
  if (!pick.isNothing()) return pick.point;
  const Box model = m_viewport.bounds();
  return model.isEmpty() ? m_viewport.camera().centre : Vec3(model.center());
}

}  // namespace handwheel
