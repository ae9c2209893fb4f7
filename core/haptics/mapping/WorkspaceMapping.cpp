// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mapping/WorkspaceMapping.h"

#include <cassert>

namespace handwheel {

Eigen::Matrix3d WorkspaceMapping::viewFromDevice() const {
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const DeviceAxis& from = axes[static_cast<std::size_t>(i)];
    m(i, from.axis) = from.isInverted ? -1.0 : 1.0;
  }
  assert(m.determinant() != 0.0 && "each axis of the device moves one of the view");
  return m;
}

Vec3 WorkspaceMapping::deviceForce(const Vec3& sceneForce) const {
  return forceGain * (viewFromDevice().transpose() * (sceneFromView.linear().transpose() * sceneForce));
}

Vec3 WorkspaceMapping::deviceTorque(const Vec3& sceneTorque) const {
  return viewFromDevice().determinant() * deviceForce(sceneTorque);
}

Vec3 outsideDeadZone(const Vec3& v, double deadZone) {
  if (deadZone == 0.0) return v;
  const double length = v.norm();
  return length > deadZone ? Vec3(v * (1.0 - deadZone / length)) : Vec3::Zero();
}

}  // namespace handwheel
