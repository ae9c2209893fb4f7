// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/FanucFrames.h"

#include <array>

namespace handwheel {

SerialArm coupled(const SerialArm& arm) {
  return arm.coupling() && arm.coupling()->factor < 0.0 ? arm : arm.withCoupling(AxisCoupling{.factor = -1.0});
}

Pose fanucWorld(const SerialArm& arm) {
  std::array<Pose, 6> axes;
  arm.jointPoses(ArmValues::Zero(6), axes);
  const Vec3 up = axes[0].linear().col(2);
  return Pose(Eigen::Translation3d(up.dot(axes[1].translation()) * up));
}

}  // namespace handwheel
