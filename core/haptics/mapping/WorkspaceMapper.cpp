// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mapping/WorkspaceMapper.h"

namespace handwheel {

namespace {

Vec3 rotationVector(const Eigen::Quaterniond& q) {
  const Eigen::AngleAxisd turn(q);  // the shorter rotation, for any length of q
  return turn.angle() * turn.axis();
}

Eigen::Quaterniond rotationBy(const Vec3& vector) {
  const double angle = vector.norm();
  if (angle == 0.0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, vector / angle));
}

}  // namespace

void WorkspaceMapper::setMapping(const WorkspaceMapping& mapping, const std::optional<Vec3>& proxy) {
  if (proxy && m_hasTip && mapping.keepsTip)
    m_tip.position = *proxy + mapping.scale / m_mapping.scale * (m_tip.position - *proxy);
  m_mapping = mapping;
  m_sceneFromDevice = mapping.sceneFromView.linear() * mapping.viewFromDevice();
  m_handedness = mapping.viewFromDevice().determinant();
  m_isAnchoring = m_hasTip && mapping.keepsTip;
  if (m_isAnchoring) return;
  m_offset.setZero();
  m_turn.setIdentity();
  m_hasTip = false;
}

WorkspaceMapper::Tip WorkspaceMapper::map(const DeviceState& device, const Vec3& velocity, double period) {
  m_tip.hasDiscontinuity = !m_hasTip;
  m_tip.isHeld = m_hasTip && (device.buttons & m_mapping.clutchButtons) != 0;
  if (m_mapping.isRateControl) {
    integrate(device, period);
    return m_tip;
  }
  if (m_tip.isHeld) {
    m_isAnchoring = true;
    m_tip.velocity.setZero();
    return m_tip;
  }
  const Placed direct = placed(device);
  if (m_isAnchoring) anchor(direct);
  m_tip.position = direct.position + m_offset;
  m_tip.orientation = (m_turn * direct.orientation).normalized();
  m_tip.velocity = m_mapping.scale * (m_sceneFromDevice * velocity);
  m_hasTip = true;
  return m_tip;
}

WorkspaceMapper::Placed WorkspaceMapper::placed(const DeviceState& device) const {
  const Vec3 moved = outsideDeadZone(device.position, m_mapping.deadZone);
  const Vec3 turned = outsideDeadZone(rotationVector(device.orientation), m_mapping.angularDeadZone);
  const Eigen::Quaterniond view(m_mapping.sceneFromView.linear());
  const Eigen::Quaterniond turn = rotationBy(m_handedness * (m_sceneFromDevice * turned));
  return {m_mapping.sceneFromView.translation() + m_mapping.scale * (m_sceneFromDevice * moved), turn * view};
}

void WorkspaceMapper::anchor(const Placed& direct) {
  m_offset = m_tip.position - direct.position;
  m_turn = (m_tip.orientation * direct.orientation.conjugate()).normalized();
  m_isAnchoring = false;
}

void WorkspaceMapper::integrate(const DeviceState& device, double period) {
  if (!m_hasTip) {
    m_tip.position = m_mapping.sceneFromView.translation();
    m_tip.orientation = Eigen::Quaterniond(m_mapping.sceneFromView.linear());
  }
  m_hasTip = true;
  m_isAnchoring = false;
  m_tip.velocity.setZero();
  if (m_tip.isHeld) return;
  const Vec3 rate = m_mapping.rateGain * outsideDeadZone(device.position, m_mapping.deadZone);
  const Vec3 turn =
      m_mapping.angularRateGain * outsideDeadZone(rotationVector(device.orientation), m_mapping.angularDeadZone);
  m_tip.velocity = m_mapping.scale * (m_sceneFromDevice * rate);
  m_tip.position += period * m_tip.velocity;
  m_tip.orientation = (rotationBy(period * m_handedness * (m_sceneFromDevice * turn)) * m_tip.orientation).normalized();
}

}  // namespace handwheel
