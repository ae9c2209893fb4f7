// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

#include <array>
#include <cstdint>

namespace handwheel {

// The device axis that moves a view axis, with its sign. Axis 0 is x, 1 is y, and 2 is z.
struct DeviceAxis {
  int axis = 0;
  bool isInverted = false;
};

// Transformation from the device workspace to the scene. Device motion is relative to the camera: mTh = mTc · cTh (He
// 2008, eq. 6-12). mTc is the view in the scene; cTh is the tip in the view, scaled and with its axes exchanged.
struct WorkspaceMapping {
  // Transformation from the view to the scene. In the view, x is right, y is up and z is towards the eye; the origin
  // should be the centre of the workspace.
  Pose sceneFromView = Pose::Identity();
  double scale = 1.0;  // mm in the scene per mm of the device, > 0
  std::array<DeviceAxis, 3> axes{DeviceAxis{0, false}, DeviceAxis{1, false}, DeviceAxis{2, false}};  // each axis once
  double forceGain = 1.0;  // N at the device per N in the scene, > 0

  // Dead zone around the rest position, mm and rad. The motion starts from zero at the border of the dead zone.
  double deadZone = 0.0;
  double angularDeadZone = 0.0;

  // True if the displacement from rest is read as a velocity.
  bool isRateControl = false;
  double rateGain = 1.0;         // 1/s: mm/s in the view, before scaling, per mm of displacement
  double angularRateGain = 1.0;  // 1/s: rad/s per rad

  std::uint32_t clutchButtons = 0;  // bits of buttons: while one is held, the device moves and the tip stays
  // True if the tip stays where it is displayed, at its proxy, when this mapping replaces another. Otherwise the tip
  // jumps to the position of the device in the new mapping.
  bool keepsTip = true;

  // Returns the matrix from device vectors to view vectors. It is a signed permutation, which may be a reflection.
  Eigen::Matrix3d viewFromDevice() const;
  // Returns the stiffness in the scene, N/mm, that is felt as `deviceStiffness` at the device.
  double sceneStiffness(double deviceStiffness) const { return deviceStiffness / (scale * forceGain); }

  // Convert force and torque in the scene to force and torque of the motors. Torque is an axial vector, so a reflection
  // reverses its sense.
  Vec3 deviceForce(const Vec3& sceneForce) const;
  Vec3 deviceTorque(const Vec3& sceneTorque) const;
};

// Applies a dead zone to a vector. The vector is shortened continuously, and keeps its direction.
Vec3 outsideDeadZone(const Vec3& v, double deadZone);

}  // namespace handwheel
