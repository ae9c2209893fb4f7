// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/ControllerConfiguration.h"

#include <array>

namespace handwheel {

namespace {

struct ArmPlaces {
  Vec3 base, up, shoulder, elbow, wrist, across;  // mm; across: the second axis
};

ArmPlaces placesOf(const SerialArm& arm, const ArmValues& values) {
  std::array<Pose, 6> poses;
  arm.jointPoses(values, poses);
  const Vec3 first = poses[0].linear().col(2);  // down where the joint counts the other way round
  return {poses[0].translation(), first.z() < 0.0 ? Vec3(-first) : first,
          poses[1].translation(), poses[2].translation(),
          poses[4].translation(), poses[1].linear().col(2)};
}

}  // namespace

ControllerConfiguration controllerConfigurationOf(const SerialArm& arm, const ArmValues& values) {
  const ArmPlaces rest = placesOf(arm, ArmValues::Zero(6)), now = placesOf(arm, values);
  const double side = (rest.wrist - rest.base).dot(rest.across.cross(rest.up)) < 0.0 ? -1.0 : 1.0;
  const Vec3 forward = side * now.across.cross(now.up), across = now.up.cross(forward);
  ControllerConfiguration configuration;
  configuration.isRear = (now.wrist - now.base).dot(forward) < 0.0;
  configuration.isElbowDown = across.dot((now.elbow - now.shoulder).cross(now.wrist - now.shoulder)) < 0.0;
  configuration.isFlipped = values[4] < 0.0;
  return configuration;
}

}  // namespace handwheel
