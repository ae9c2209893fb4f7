// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/ClosedFormIk.h"

#include <functional>
#include <optional>
#include <span>

namespace handwheel {

// The configuration of an arm with a spherical wrist, as controllers denote it. It says in which of its ways the arm
// reaches a pose.
struct ControllerConfiguration {
  bool isRear = false;       // the wrist is behind the first axis, seen from how the arm looks with all joints at 0
  bool isElbowDown = false;  // the wrist is behind the lower arm
  bool isFlipped = false;    // the fifth joint is below 0
};

// Six revolute joints.
ControllerConfiguration controllerConfigurationOf(const SerialArm& arm, const ArmValues& values);

// The closed form of an arm whose ways such a configuration tells apart, which is one with a spherical wrist. None: it
// is another.
std::optional<ClosedFormIk> closedFormOfSphericalWrist(const SerialArm& arm);

// rad: so far may a place in a file have the tip turned, as files round poses.
inline constexpr double kPoseRounding = 1e-4;

// Axis 5 is so near 0 that only the sum of the turns of the axes 4 and 6 is given by a pose of a file.
bool isWristInLine(const ArmValues& values);

// How far a joint may be from where it was when a pose was written to a file; rad. The nearer the axes 4 and 6 are to
// being in line, the more these. Not where they are in line.
double jointRounding(const ArmValues& values, Eigen::Index joint);

// What the joint values of a way must be like.
struct WantedWay {
  // The value of a joint, counted with its whole turns, and how far it may be off; rad.
  std::function<bool(Eigen::Index, double, double)> takesJoint;
  std::function<bool(const ArmValues&)> takes;  // all of them together
};

// The joint values that are wanted, within the limits, which bring the tip of the arm there as exactly as files have
// it; the nearest to the first of the references where they leave a choice. The others are tried after it: where two
// axes are in line, their share in the turn is from these. None: there are none. closed: that of the arm.
std::optional<ArmValues> jointsOfWay(const WantedWay& wanted, const SerialArm& arm, const ClosedFormIk& closed,
                                     const Pose& tip, std::span<const ArmValues> references);

}  // namespace handwheel
