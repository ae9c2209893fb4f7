// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mapping/WorkspaceMapping.h"
#include "haptics/servo/ForceRenderer.h"

namespace handwheel {

// Test force that pulls along the axes of the device, one after another. In the order +x, -x, +y, -y, +z and -z; each
// pull is a half sine, so that the force is continuous. Servo thread.
class ForceTest : public ForceRenderer {
 public:
  static constexpr double kPullTime = 0.8;  // s
  static constexpr double kDuration = 6.0 * kPullTime;

  // force: N at the device. mapping: the one in use during the test.
  ForceTest(double force, const WorkspaceMapping& mapping);

  void tick(const TipState& tip, ForceOut& out) noexcept override;

 private:
  Eigen::Matrix3d m_sceneFromDevice;  // for a force at the device, the one in the scene that it results from
  double m_force;
  double m_begin = 0.0;  // s, time of the first tick
  bool m_hasBegun = false;
};

}  // namespace handwheel
