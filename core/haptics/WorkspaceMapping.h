// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Device.h"

#include <array>
#include <cstdint>

namespace handwheel {

// One axis of the view: which axis of the device moves it (0 x, 1 y, 2 z), and which way.
struct DeviceAxis {
  int axis = 0;
  bool isInverted = false;
};

// How the frame of the device lies in the scene. What the device does is done as seen by the camera: mTh = mTc · cTh
// (He 2008, eq. 6-12), with mTc the view in the scene and cTh the tip in the view, scaled and with its axes exchanged.
struct WorkspaceMapping {
  // From the view (x right, y up, z towards the eye; origin where the centre of the workspace is to be) to the scene.
  Pose sceneFromView = Pose::Identity();
  double scale = 1.0;  // mm in the scene for one of the device, > 0
  std::array<DeviceAxis, 3> axes{DeviceAxis{0, false}, DeviceAxis{1, false}, DeviceAxis{2, false}};  // each axis once
  double forceGain = 1.0;  // N at the device for one in the scene, > 0

  // Around rest nothing moves: mm and rad. The motion begins at the border from zero.
  double deadZone = 0.0;
  double angularDeadZone = 0.0;

  // The displacement from rest is read as a velocity.
  bool isRateControl = false;
  double rateGain = 1.0;         // 1/s: mm/s in the view, before the scale, for each mm
  double angularRateGain = 1.0;  // 1/s: rad/s for each rad

  std::uint32_t clutchButtons = 0;  // bits: while one is held the device moves and the tip stays
  // When this mapping takes the place of another the tip stays where it is seen, at its proxy, and goes on from there.
  // Else it goes where the device is in the new mapping, which is a leap.
  bool keepsTip = true;

  // The device's vectors in the view: a permutation with signs, so a reflection when an odd number is inverted.
  Eigen::Matrix3d viewFromDevice() const;
  // The stiffness in the scene, N/mm, that is felt as so much at the device.
  double sceneStiffness(double deviceStiffness) const { return deviceStiffness / (scale * forceGain); }

  // What is felt in the scene, for the motors. Torque is an axial vector: a reflection turns its sense.
  Vec3 deviceForce(const Vec3& sceneForce) const;
  Vec3 deviceTorque(const Vec3& sceneTorque) const;
};

// v without what lies within so much of zero: continuous, and in the same direction.
Vec3 outsideDeadZone(const Vec3& v, double deadZone);

}  // namespace handwheel
