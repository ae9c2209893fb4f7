// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/DeviceView.h"

#include "viewport/Viewport.h"
#include "viewport/camera/CameraNavigation.h"
#include "window/haptics/HapticSession.h"

#include <algorithm>

namespace handwheel {

DeviceView::DeviceView(HapticSession& session, Viewport& viewport, QObject* parent)
    : QObject(parent), m_session(session), m_viewport(viewport) {
  connect(&viewport, &Viewport::cameraChanged, this, &DeviceView::followCamera);
  connect(&session, &HapticSession::sampled, this, &DeviceView::draw);
  connect(&session, &HapticSession::chosenChanged, this, [this] {
    if (m_session.isOpen() && !m_isOpen) followModel();
    m_isOpen = m_session.isOpen();
    draw();
  });
}

void DeviceView::followModel() {
  followCamera();
  m_session.recentre();
}

void DeviceView::followCamera() {
  if (!m_session.isOpen()) return;
  const CameraState camera = m_viewport.camera();
  m_session.setView(camera, m_viewport.bounds(), surfaceInMiddle(camera));
}

// The front of the model replaces a surface that cannot be picked yet, so that no tip begins inside.
std::optional<Vec3> DeviceView::surfaceInMiddle(const CameraState& camera) const {
  const Box model = m_viewport.bounds();
  if (model.isEmpty()) return std::nullopt;
  const Vec3 towards = camera.towardsViewer();
  if (!m_viewport.isPickingReady()) {
    double front = 0.0;
    for (const Vec3& corner : cornersOf(model)) front = std::max(front, (corner - camera.centre).dot(towards));
    return camera.centre + front * towards;
  }
  const bool isPerspective = camera.projection == Projection::Perspective;
  const double before = isPerspective ? camera.eyeDistance() : camera.height + model.diagonal().norm();
  const Pick middle = m_viewport.pickAlong(camera.centre + before * towards, -towards);
  return middle.isNothing() ? std::nullopt : std::optional(middle.point);
}

void DeviceView::showInstead(const std::optional<DeviceCursor>& cursor) {
  m_instead = cursor;
  draw();
}

void DeviceView::draw() {
  if (m_instead) return m_viewport.setDeviceCursor(m_instead);
  const ServoSample* const last = m_session.latest();
  if (!last || last->device.status != DeviceStatus::Ready) return m_viewport.setDeviceCursor({});
  DeviceCursor cursor;
  cursor.tip = last->tip.position;
  cursor.proxy = last->felt.proxy;
  cursor.force = last->felt.force;
  const WorkspaceMapping mapping = m_session.mappingInScene();
  cursor.limit = m_session.capabilities().maxForce / mapping.forceGain;
  m_viewport.setDeviceCursor(cursor);
}

}  // namespace handwheel
