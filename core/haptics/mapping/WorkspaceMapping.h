// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

#include <array>
#include <cstdint>

namespace handwheel {

// The device axis that moves a view axis, with its sign. 0 x, 1 y, 2 z.
struct DeviceAxis {
  int axis = 0;
  bool isInverted = false;
};

// Transformation from the device workspace to the scene. Device motion is relative to the camera: mTh = mTc · cTh (He
// 2008, eq. 6-12), with mTc the view in the scene and cTh the tip in the view, scaled and with its axes exchanged.
struct WorkspaceMapping {
  // Transformation to the scene from the view (x right, y up, z towards the eye; the origin is to be the centre of the
  // workspace).
  Pose sceneFromView = Pose::Identity();
  double scale = 1.0;  // mm in the scene for one of the device, > 0
  std::array<DeviceAxis, 3> axes{DeviceAxis{0, false}, DeviceAxis{1, false}, DeviceAxis{2, false}};  // each axis once
  double forceGain = 1.0;  // N at the device for one in the scene, > 0

  // Dead zone around the rest position: mm and rad. The motion starts from zero at its border.
  double deadZone = 0.0;
  double angularDeadZone = 0.0;

  // The displacement from rest is read as a velocity.
  bool isRateControl = false;
  double rateGain = 1.0;         // 1/s: mm/s in the view, before the scale, for each mm
  double angularRateGain = 1.0;  // 1/s: rad/s for each rad

  std::uint32_t clutchButtons = 0;  // bits: while one is held the device moves and the tip stays
  // When this mapping replaces another, the tip stays where it is displayed, at its proxy, and continues from there.
  // Otherwise it jumps to the position of the device in the new mapping.
  bool keepsTip = true;

  // Returns the matrix from device vectors to view vectors: a signed permutation, so it may be a reflection.
  Eigen::Matrix3d viewFromDevice() const;
  // Returns the stiffness in the scene, N/mm, that is felt as `deviceStiffness` at the device.
  double sceneStiffness(double deviceStiffness) const { return deviceStiffness / (scale * forceGain); }

  // Convert force and torque in the scene to those of the motors. Torque is an axial vector: a reflection reverses its
  // sense.
  Vec3 deviceForce(const Vec3& sceneForce) const;
  Vec3 deviceTorque(const Vec3& sceneTorque) const;
};

// Applies a dead zone to a vector: shortens it continuously, keeping its direction.
Vec3 outsideDeadZone(const Vec3& v, double deadZone);

}  // namespace handwheel
