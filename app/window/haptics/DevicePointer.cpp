// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/DevicePointer.h"

#include "viewport/Viewport.h"
#include "window/haptics/HapticSceneBuilder.h"
#include "window/haptics/HapticSession.h"
#include "window/tools/ToolHost.h"

#include <QGuiApplication>

namespace handwheel {

namespace {

constexpr std::uint32_t kFirst = 1u << 0, kSecond = 1u << 1;
constexpr double kStill = 0.25;  // pixels: a hand that moves less moves nothing
// A tip that lies in the surface itself would begin behind it as often as before it.
constexpr double kClear = 2.0;          // pixels
constexpr double kNotch = 15.0;         // degrees of the wheel
constexpr double kDepthOfNotch = 0.01;  // fraction of the height of the view

double pixelOf(const Viewport& viewport) {
  return viewport.camera().height / std::max(1, viewport.height());
}

}  // namespace

DevicePointer::DevicePointer(HapticSession& session, Viewport& viewport, ToolHost& tools, HapticSceneBuilder& scene)
    : QObject(&tools), m_session(session), m_viewport(viewport), m_tools(tools), m_scene(scene) {
  connect(&session, &HapticSession::sampled, this, &DevicePointer::follow);
  connect(&session, &HapticSession::chosenChanged, this, &DevicePointer::follow);
  connect(&tools, &ToolHost::updated, this, &DevicePointer::pull);
  tools.setMouseDevice([this](const PointerInput& input, const ViewRay& ray) { return placeMouse(input, ray); },
                       [this] { return m_session.mouse() != nullptr; });
}

void DevicePointer::follow() {
  if (m_session.mouse()) return;  // its events come from the window
  const ServoSample* const sample = m_session.latest();
  const bool isThere = sample && sample->device.status == DeviceStatus::Ready && !m_session.isTesting();
  isThere ? point(*sample) : letGo();
}

void DevicePointer::point(const ServoSample& sample) {
  const std::uint32_t buttons = sample.device.buttons & ~m_session.mapping().clutchButtons;
  const bool isHeld = (buttons & kFirst) != 0, isSecondHeld = (buttons & kSecond) != 0;
  PointerEvent event = eventAt(sample);
  if (isHeld != m_isHeld) {
    m_isHeld = isHeld;
    event.kind = isHeld ? PointerEvent::Kind::Press : PointerEvent::Kind::Release;
    event.button = PointerButton::First;
    m_tools.point(event);
    pull();
  } else if (!m_isPointing || (sample.tip.position - m_last).norm() > kStill * event.pixel ||
             (sample.felt.proxy - m_lastProxy).norm() > kStill * event.pixel) {
    event.kind = isHeld ? PointerEvent::Kind::Drag : PointerEvent::Kind::Hover;
    event.button = isHeld ? PointerButton::First : PointerButton::None;
    m_tools.point(event);
  } else if (isSecondHeld == m_isSecondHeld) {
    return;
  }
  m_isPointing = true;
  m_last = sample.tip.position;
  m_lastProxy = sample.felt.proxy;
  if (isSecondHeld && !m_isSecondHeld) {
    event.kind = PointerEvent::Kind::Press;
    event.button = PointerButton::Second;
    m_tools.point(event);
  }
  m_isSecondHeld = isSecondHeld;
}

// A device that goes takes its hand off: nothing may stay in the air that the next one would drag on.
void DevicePointer::letGo() {
  if (!m_isPointing) return;
  m_isPointing = m_isSecondHeld = false;
  if (std::exchange(m_isHeld, false)) m_tools.runner().perform("revert");
  PointerEvent event;
  event.kind = PointerEvent::Kind::Leave;
  m_tools.point(event);
  pull();
}

// Tools ask for the surface along the line of sight, so the ray is that through the displayed cursor; the pose is that
// of the hand itself, which may be below the surface.
PointerEvent DevicePointer::eventAt(const ServoSample& sample) const {
  const CameraState camera = m_viewport.camera();
  const Vec3& position = sample.felt.proxy;
  PointerEvent event;
  event.pixel = pixelOf(m_viewport);
  const Qt::KeyboardModifiers keys = QGuiApplication::keyboardModifiers();
  event.modifiers = {keys.testFlag(Qt::ShiftModifier), keys.testFlag(Qt::ControlModifier),
                     keys.testFlag(Qt::AltModifier)};
  event.device = Eigen::Translation3d(sample.tip.position) * sample.tip.orientation;
  event.proxy = position;
  if (sample.felt.isHeld) event.held = sample.felt.held;
  if (camera.projection == Projection::Perspective) {
    event.eye = camera.eye();
    event.focus = camera.eyeDistance();
    event.ray = {camera.eye(), (position - camera.eye()).stableNormalized()};
  } else {
    const Box model = m_viewport.bounds();
    const double before = camera.height + (model.isEmpty() ? 0.0 : model.diagonal().norm());
    event.ray = {position + before * camera.towardsViewer(), -camera.towardsViewer()};
  }
  return event;
}

// A spring held by the mouse would pull at a device from any distance.
void DevicePointer::pull() {
  if (!m_session.isOpen()) return;
  const Tool* const tool = m_tools.runner().tool();
  m_scene.setHolding(m_isHeld);
  const bool isForDevice = m_isHeld || QGuiApplication::mouseButtons() == Qt::NoButton;
  m_scene.setSprings(tool && isForDevice ? tool->forces() : std::vector<DeviceSpring>());
}

std::optional<Pose> DevicePointer::placeMouse(const PointerInput& input, const ViewRay& ray) {
  MouseDevice* const mouse = m_session.mouse();
  if (!mouse) return std::nullopt;
  if (input.kind == PointerInput::Kind::Leave) {
    mouse->leave();
    m_depth.resetWheel();
    return std::nullopt;
  }
  m_isHeld = input.held.testFlag(Qt::LeftButton);
  if (input.kind == PointerInput::Kind::Wheel && !input.modifiers.testFlag(Qt::ControlModifier))
    m_depth.turnWheel(input.wheel / kNotch, kDepthOfNotch * m_viewport.camera().height);
  const Pick under = m_isHeld ? Pick{} : m_viewport.pickAlong(ray.origin, ray.direction);
  if (!under.isNothing()) m_depth.setSurface((under.point - ray.origin).norm() - kClear * pixelOf(m_viewport));
  const Vec3 position = m_depth.positionOn(ray.origin, ray.direction);
  mouse->point(position, (m_isHeld ? kFirst : 0u) | (input.held.testFlag(Qt::RightButton) ? kSecond : 0u));
  return Pose(Eigen::Translation3d(position) * m_viewport.camera().orientation);
}

}  // namespace handwheel
