// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/device/MouseDevice.h"
#include "haptics/servo/ForceTest.h"
#include "window/haptics/ActiveDevice.h"
#include "window/haptics/DeviceMapping.h"
#include "window/haptics/DeviceMessages.h"

#include <algorithm>

// The part of HapticSession that works with an open device: recording, mapping, forces, and samples.
namespace handwheel {

namespace {

constexpr int kRateMs = 500;           // over which the rate is measured
constexpr double kTestTail = 0.2;      // s after the last pull, for what the safety chain has delayed
constexpr double kLetGo = 0.02;        // N: a force that may break off unnoticed
constexpr double kLongestWait = 0.25;  // s for it: what damps a moving hand may stay
constexpr double kFailedTime = 2.0;    // s after which a device does not recover by itself
constexpr const char* kTestNote = R"({"test":{}})";

}  // namespace

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

const ServoStatistics* HapticSession::measure() const {
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
  storeMapping(m_chosen.driver, mapping);
  applyMapping(true, true);  // with other axes or another scale the force turns about
  emit mappingChanged();
}

void HapticSession::setView(const CameraState& camera, const Box& model, const std::optional<Vec3>& seen) {
  m_camera = camera;
  m_model = model;
  m_seen = seen;
  if (!m_open) return;
  const ServoSample* const last = latest();
  applyMapping(last && isInView(camera, last->tip.position), false);
}

void HapticSession::recentre() {
  applyMapping(false, false);
}

// The mouse points in the scene itself.
WorkspaceMapping HapticSession::mappingInScene() const {
  if (!m_open || m_open->mouse) return {};
  return mappingInView(m_mapping, m_open->capabilities, m_camera, m_model, m_seen);
}

// If mappings follow closely, the loop takes the last only: a tip that is to jump would stay at its old position, which
// may be inside the model, if the next mapping kept it.
void HapticSession::applyMapping(bool keepsTip, bool isDiscontinuous) {
  if (!m_open) return;
  WorkspaceMapping mapping = mappingInScene();
  mapping.keepsTip = keepsTip && !m_open->mouse && !m_open->jumpedAfter;
  if (!keepsTip) m_open->jumpedAfter = m_open->loop->latest().tick;
  m_open->isMoving = true;
  emit viewChanged();
  m_open->isMoving = false;
  if (isDiscontinuous) announceDiscontinuity();
  m_open->loop->setMapping(mapping, std::move(m_open->movedScene));
}

void HapticSession::setTouch(const TouchSettings& touch) {
  if (touch == m_touch) return;
  m_touch = touch;
  storeTouch(touch);
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
  scene->renderer = std::make_unique<ForceTest>(kTestForce, mappingInScene());
  m_testEnd.reset();
  setScene(std::move(scene), kTestNote);
  m_testEnd = latest()->tip.time + ForceTest::kDuration + kTestTail;
}

void HapticSession::setScene(std::unique_ptr<HapticScene> scene, const std::string& note) {
  if (!m_open || m_testEnd) return;
  if (m_open->recorder) m_open->recorder->noteNextScene(note);
  if (m_open->isMoving) {
    m_open->movedScene = std::move(scene);
  } else {
    m_open->loop->setScene(std::move(scene));
  }
}

void HapticSession::announceDiscontinuity() {
  if (m_open) m_open->loop->announceDiscontinuity();
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
  // The tick that was running then may not have had the mapping.
  if (m_open->jumpedAfter && m_open->sample->tick > *m_open->jumpedAfter + 1) m_open->jumpedAfter.reset();
  measureRate();
  if (m_open->sample->device.status != before) reportStatus(m_open->sample->device.status);
  if (isGone()) return lose(m_open->sample->device.status);
  if (m_open->recorder && m_open->recorder->isFull()) stopRecording();
  if (m_testEnd && m_open->sample->tip.time > *m_testEnd) endForceTest();
  if (m_open->isChangingSince) changeServo();
  emit sampled();
}

void HapticSession::endForceTest() {
  m_testEnd.reset();
  setScene(std::make_unique<HapticScene>());
  emit sceneRequested();
}

void HapticSession::measureRate() {
  if (m_rateClock.elapsed() < kRateMs) return;
  const std::uint64_t tick = m_open->sample->tick;
  m_rate = 1e3 * static_cast<double>(tick - m_rateTick) / static_cast<double>(m_rateClock.restart());
  m_rateTick = tick;
}

void HapticSession::reportStatus(DeviceStatus status) {
  m_open->failedAt.reset();
  if (m_open->mouse) return;
  if (status == DeviceStatus::Failed) m_open->failedAt = m_open->sample->tip.time;
  if (status != DeviceStatus::Absent && status != DeviceStatus::Failed) return;
  Message lost = lostMessage(nameOf(m_chosen), status);
  lost.action = [this, device = m_chosen] { openAgain(device); };
  emit message(lost);
}

// A line that was silent for a moment speaks again by itself. A mouse is absent while it is outside the view.
bool HapticSession::isGone() const {
  const ServoSample& last = *m_open->sample;
  if (last.device.status == DeviceStatus::Absent) return !m_open->mouse;
  return m_open->failedAt && last.tip.time > *m_open->failedAt + kFailedTime;
}

void HapticSession::lose(DeviceStatus status) {
  closeLoop();
  setLost(status);
  emit chosenChanged();
}

}  // namespace handwheel
