// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/SessionDevicePanel.h"

#include "window/haptics/DeviceMapping.h"
#include "window/haptics/HapticSession.h"

namespace handwheel {

namespace {
constexpr int kRunMs = 500;              // between figures that a person can read
constexpr double kLeadSpeed = 150.0;     // mm/s: a hand that leaps would only be held back by the safety chain
constexpr double kSamplePeriod = 0.016;  // s, from one sample to the next
}  // namespace

SessionDevicePanel::SessionDevicePanel(HapticSession& session, QWidget* parent)
    : DevicePanel(parent), m_session(session) {
  connect(this, &DevicePanel::deviceChosen, &session, &HapticSession::choose);
  connect(this, &DevicePanel::deviceLeft, &session, &HapticSession::close);
  connect(this, &DevicePanel::forceOnChanged, &session, &HapticSession::setForceOn);
  connect(this, &DevicePanel::forceTestRequested, &session, &HapticSession::startForceTest);
  connect(this, &DevicePanel::mappingChanged, &session, &HapticSession::setMapping);
  connect(this, &DevicePanel::rescanRequested, &session, [&session] {  // watching begins with a look
    session.setWatching(false);
    session.setWatching(true);
  });
  connect(&session, &HapticSession::foundChanged, this, &SessionDevicePanel::showChosen);
  connect(&session, &HapticSession::chosenChanged, this, &SessionDevicePanel::showChosen);
  connect(&session, &HapticSession::forceOnChanged, this, &SessionDevicePanel::showChosen);
  connect(&session, &HapticSession::mappingChanged, this, [this] { setMapping(m_session.mapping()); });
  connect(this, &DevicePanel::handLed, this, [this](const HandPose& hand) { m_goal = hand; });
  connect(&session, &HapticSession::sampled, this, &SessionDevicePanel::leadHand);
  connect(&session, &HapticSession::sampled, this, &SessionDevicePanel::showTick);
  setMapping(session.mapping());
  showChosen();
}

void SessionDevicePanel::setSpaceMice(std::vector<std::string> names) {
  m_spaceMice = std::move(names);
  showChosen();
}

void SessionDevicePanel::setTurningAxis(const std::optional<Ray>& axis) {
  m_turningAxis = axis;
  nameAxes();
}

void SessionDevicePanel::nameAxes() {
  QStringList words;
  const ServoSample* const now = m_session.latest();
  if (m_turningAxis && now) {
    for (const AboutAxis about : axesAbout(*m_turningAxis, m_session.mappingInScene(), now->tip.position)) {
      words << (about == AboutAxis::Along    ? tr("along (Z)")
                : about == AboutAxis::Radius ? tr("radius (X)")
                : about == AboutAxis::Across ? tr("across")
                                             : QString());
    }
  }
  setAxisWords(words);
}

void SessionDevicePanel::showEvent(QShowEvent* event) {
  m_session.setWatching(true);
  showChosen();
  DevicePanel::showEvent(event);
}

void SessionDevicePanel::hideEvent(QHideEvent* event) {
  m_session.setWatching(false);
  DevicePanel::hideEvent(event);
}

void SessionDevicePanel::showChosen() {
  DeviceInUse view;
  const QList<DeviceInfo> found = m_session.found();
  view.found.assign(found.begin(), found.end());
  if (const DeviceInfo chosen = m_session.chosen(); !chosen.driver.empty()) view.chosen = chosen;
  view.capabilities = m_session.capabilities();
  view.status = m_session.status();
  view.spaceMice = m_spaceMice;
  view.isPointer = m_session.mouse() != nullptr;
  view.isLed = m_session.simulatedHand() != nullptr;
  view.isForceOn = m_session.isForceOn();
  showDevice(view);
  showRun();
}

void SessionDevicePanel::showTick() {
  if (!isVisible()) return;
  if (const ServoSample* const last = m_session.latest())
    showSample(*last, 1.0 / m_session.mappingInScene().sceneStiffness(1.0));
  if (m_sinceRun.isValid() && m_sinceRun.elapsed() < kRunMs) return;
  showRun();
}

// Also while the panel is hidden: what was begun is brought to its end.
void SessionDevicePanel::leadHand() {
  SimulatedDevice* const hand = m_session.simulatedHand();
  if (!hand) return m_goal.reset();
  if (m_goal) {
    HandPose next = *m_goal;
    const Vec3 displacement = next.position - hand->target().position;
    const double most = kLeadSpeed * kSamplePeriod;
    if (displacement.norm() > most) {
      next.position = hand->target().position + displacement * (most / displacement.norm());
    } else {
      m_goal.reset();
    }
    hand->setTarget(next);
  }
  if (isVisible()) showHand(m_goal ? *m_goal : hand->target());
}

void SessionDevicePanel::showRun() {
  nameAxes();
  m_sinceRun.start();
  showLoop({m_session.rate(), m_session.missedTicks(), m_session.realTime()});
  if (const ServoStatistics* const measure = m_session.measure()) showTiming(*measure);
}

}  // namespace handwheel
