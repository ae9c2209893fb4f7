// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The forces of PlaceBodyTool at a device.
#include "base/Tolerance.h"
#include "tools/cell/PlaceBodyTool.h"

namespace handwheel {

namespace {

constexpr double kLeastForce = 1e-9;  // N: a spring without a force would only hold the hand back

}  // namespace

// A handle moves the object along or about its axis only: the hand does the work of the object against the force.
void PlaceBodyTool::feel(const PointerEvent& event) {
  m_drag->push.reset();
  if (!event.device || !m_drag->hand || m_shown.matrix() == m_drag->start.matrix()) return;
  const Vec3 hand = event.device->translation();
  const PlacingHandles& handles = m_drag->handles;
  const Vec3 reference = m_drag->handle ? handles.centre : hand;
  const HeldForce::Felt& felt = m_approach.follow(m_shown * m_drag->start.inverse(Eigen::Isometry), reference);
  const DistanceWrench& wrench = felt.wrench;
  if (!m_drag->handle) {
    if (!wrench.force.isZero(0.0) || !wrench.torque.isZero(0.0))
      m_drag->push = approachSpring(*event.device, wrench.force, wrench.torque);
    return;
  }
  const Vec3& axis = handles.axes[static_cast<std::size_t>(m_drag->handle->axis)];
  Vec3 force = axis.dot(wrench.force) * axis;
  if (m_drag->handle->isRing) {
    const Vec3 around = axis.cross(hand - handles.centre);  // Its length is that of the lever
    if (around.norm() < tolerance::kLeastLever) return;
    force = axis.dot(wrench.torque) / around.squaredNorm() * around;
    const double size = force.norm(), most = m_approach.settings().largestForce;
    if (size > most) force *= most / size;
  }
  if (force.norm() > kLeastForce) m_drag->push = approachSpring(*event.device, force, std::nullopt);
}

std::vector<DeviceSpring> PlaceBodyTool::forces() const {
  if (!m_drag || !m_drag->push || !m_approach.settings().isFelt) return {};
  return {*m_drag->push};
}

void PlaceBodyTool::letGo() {
  m_drag.reset();
  m_approach.release();
}

}  // namespace handwheel
