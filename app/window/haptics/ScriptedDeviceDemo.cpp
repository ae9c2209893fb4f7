// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/ScriptedDeviceDemo.h"

#include "haptics/device/SimulatedDevice.h"
#include "viewport/Viewport.h"
#include "window/haptics/BuiltInDevices.h"
#include "window/haptics/HapticSession.h"

#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

constexpr double kLongestShowWait = 60.0;  // s for what a step waits for
constexpr double kHandSpeed = 0.45;        // heights of the view per second
constexpr double kShortest = 0.25;         // s of a movement
constexpr double kArrived = 2.0;           // pixels
constexpr double kLift = 0.15;             // fraction of the distance through the air
constexpr double kEffort = 4.0;            // 1/s: how fast the hand makes up for what holds the tip
constexpr double kMostEffort = 0.2;        // fraction of the height of the view
constexpr int kMostSamples = 100;          // for the tip to arrive, which may be held back
constexpr int kLeastSamples = 3;           // at rest: tools have seen the buttons, however slow the machine
constexpr double kFrame = 0.016;           // s, from one sample to the next

// Position, velocity and acceleration begin and end at rest (minimum jerk: Flash and Hogan 1985, eq. 3).
double smooth(double s) {
  return s * s * s * (10.0 + s * (6.0 * s - 15.0));
}

}  // namespace

ScriptedDeviceDemo::ScriptedDeviceDemo(HapticSession& session, Viewport& viewport, QObject* parent)
    : QObject(parent), m_session(session), m_viewport(viewport) {
  connect(&session, &HapticSession::sampled, this, &ScriptedDeviceDemo::follow);
  connect(&session, &HapticSession::chosenChanged, this, [this] {  // by somebody else
    if (m_isRunning && m_session.chosen().driver != kSimulatedDriver) stop();
  });
}

ScriptedDeviceDemo::~ScriptedDeviceDemo() = default;

void ScriptedDeviceDemo::start(std::vector<DemoStep> steps) {
  stop();
  if (steps.empty()) return;
  m_driver = m_session.chosen().driver;
  m_address = m_session.chosen().address;
  m_steps = std::move(steps);
  m_step = 0;
  m_effort.setZero();
  if (!m_session.simulatedHand()) m_session.choose(kSimulatedDriver, kSimulatedAddress);
  m_isRunning = true;
  beginStep();
}

void ScriptedDeviceDemo::stop() {
  finish(false);
}

void ScriptedDeviceDemo::finish(bool isWhole) {
  if (!std::exchange(m_isRunning, false)) return;
  m_steps.clear();
  m_caption.clear();
  m_detail.clear();
  if (m_session.chosen().driver == kSimulatedDriver) {
    press(0);
    if (m_driver.empty()) {
      m_session.close();
    } else if (m_driver != kSimulatedDriver) {
      m_session.choose(m_driver, m_address);
    }
  }
  emit captionChanged();
  emit ended(isWhole);
}

void ScriptedDeviceDemo::beginStep() {
  const DemoStep& step = m_steps[m_step];
  if (!step.caption.isEmpty()) {
    m_caption = step.caption;
    m_detail = step.detail;
    emit captionChanged();
  }
  m_phase = Phase::Waiting;
  m_clock.start();
  if (step.begin) step.begin();
}

double ScriptedDeviceDemo::seconds() const {
  return m_pace * 1e-3 * static_cast<double>(m_clock.elapsed());
}

void ScriptedDeviceDemo::follow() {
  const ServoSample* const now = m_session.latest();
  if (!m_isRunning || !now || now->device.status != DeviceStatus::Ready || !m_session.simulatedHand()) return;
  const DemoStep& step = m_steps[m_step];
  switch (m_phase) {
    case Phase::Waiting:
      if (step.isReady && !step.isReady()) {
        if (seconds() > m_pace * kLongestShowWait) stop();
        return;
      }
      startMoving(*now);
      return;
    case Phase::Moving:
      return move(*now);
    case Phase::Resting:
      lead(*now, m_to);
      if (++m_samples < kLeastSamples || seconds() < step.rest) return;
      if (++m_step < m_steps.size()) return beginStep();
      finish(true);
  }
}

void ScriptedDeviceDemo::startMoving(const ServoSample& now) {
  const DemoStep& step = m_steps[m_step];
  m_from = m_to = now.tip.position;
  if (step.goal) {
    const std::optional<Vec3> goal = step.goal();
    if (!goal) return stop();
    m_to = *goal;
  }
  const double distance = (m_to - m_from).norm(), height = m_viewport.camera().height;
  m_duration = distance > 0.0 ? std::max(kShortest, distance / (kHandSpeed * height)) : 0.0;
  m_lift = step.buttons == 0 ? kLift * distance : 0.0;
  m_phase = Phase::Moving;
  m_samples = 0;
  m_clock.start();
  move(now);
}

Vec3 ScriptedDeviceDemo::positionAt(double share) const {
  const double s = smooth(share);
  return m_from + s * (m_to - m_from) + 4.0 * s * (1.0 - s) * m_lift * m_viewport.camera().towardsViewer();
}

void ScriptedDeviceDemo::move(const ServoSample& now) {
  const double passed = seconds();
  lead(now, positionAt(m_duration > 0.0 ? std::min(1.0, passed / m_duration) : 1.0));
  if (passed < m_duration) return;
  const double pixel = m_viewport.camera().height / std::max(1, m_viewport.height());
  const bool isThere = (now.tip.position - m_to).norm() < kArrived * pixel;
  if (!isThere && ++m_samples < kMostSamples) return;
  m_phase = Phase::Resting;
  m_samples = 0;
  m_clock.start();
}

// A person sees where the tip is, pushes further where it does not follow, and goes on so until what held it lets go.
void ScriptedDeviceDemo::lead(const ServoSample& now, const Vec3& goal) {
  const WorkspaceMapping mapping = m_session.mappingInScene();
  m_effort += m_pace * kEffort * kFrame * (goal - now.tip.position);
  const double most = kMostEffort * m_viewport.camera().height;
  if (m_effort.norm() > most) m_effort *= most / m_effort.norm();
  const Vec3 inView = mapping.sceneFromView.linear().transpose() * (goal + m_effort - now.tip.position);
  HandPose pose;
  pose.position = now.device.position + mapping.viewFromDevice().transpose() * inView / mapping.scale;
  pose.buttons = m_steps[m_step].buttons;
  m_session.simulatedHand()->setTarget(pose);
}

void ScriptedDeviceDemo::press(std::uint32_t buttons) {
  const ServoSample* const now = m_session.latest();
  if (!now || !m_session.simulatedHand()) return;
  HandPose pose;
  pose.position = now->device.position;
  pose.buttons = buttons;
  m_session.simulatedHand()->setTarget(pose);
}

}  // namespace handwheel
