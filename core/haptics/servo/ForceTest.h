// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mapping/WorkspaceMapping.h"
#include "haptics/servo/ForceRenderer.h"

namespace handwheel {

// Test force that pulls along the axes of the device, one after another. The order is +x, -x, +y, -y, +z and -z. Each
// pull is a half sine, so that the force is continuous. The force is computed on the servo thread.
class ForceTest : public ForceRenderer {
 public:
  static constexpr double kPullTime = 0.8;  // s
  static constexpr double kDuration = 6.0 * kPullTime;

  // force: the largest force at the device, N. mapping: the mapping in use during the test.
  ForceTest(double force, const WorkspaceMapping& mapping);

  void tick(const TipState& tip, ForceOut& out) noexcept override;

 private:
  Eigen::Matrix3d m_sceneFromDevice;  // converts a force at the device to the force in the scene that causes it
  double m_force;
  double m_begin = 0.0;  // time of the first tick, s
  bool m_hasBegun = false;
};

}  // namespace handwheel
