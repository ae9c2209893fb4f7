// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/ClosedFormIk.h"

#include <functional>
#include <optional>
#include <span>

namespace handwheel {

// The configuration of an arm with a spherical wrist, as controllers denote it. It distinguishes the solutions for a
// pose.
struct ControllerConfiguration {
  // The wrist is behind the first axis, relative to the direction that the arm faces with all joints at 0.
  bool isRear = false;
  bool isElbowDown = false;  // the wrist is behind the lower arm
  bool isFlipped = false;    // the fifth joint is below 0
};

// Returns the configuration of an arm of six revolute joints.
ControllerConfiguration controllerConfigurationOf(const SerialArm& arm, const ArmValues& values);

// Returns the closed form of an arm whose solutions are distinguished by such a configuration, which is one with a
// spherical wrist. None for others.
std::optional<ClosedFormIk> closedFormOfSphericalWrist(const SerialArm& arm);

// Orientation error of the tip, rad, that the rounding of poses in files may cause.
inline constexpr double kPoseRounding = 1e-4;

// Returns true if axis 5 is so near 0 that a pose of a file determines only the sum of the angles of the axes 4 and 6.
bool isWristInLine(const ArmValues& values);

// Returns the error of a joint, rad, that the rounding of a pose in a file may cause. It grows for the axes 4 and 6 the
// nearer they are to being in line. Not defined if they are in line.
double jointRounding(const ArmValues& values, Eigen::Index joint);

// The conditions on the joint values of a solution.
struct WantedConfiguration {
  // Accepts the value of a joint, counted with its whole turns; the last argument is its tolerance; rad.
  std::function<bool(Eigen::Index, double, double)> takesJoint;
  std::function<bool(const ArmValues&)> takes;  // accepts all of them together
};

// Finds the accepted joint values within the limits that bring the tip of the arm to a pose within the rounding of
// files; if there are several, the nearest to the first of the references. The others are tried after it: if two axes
// are in line, their share of the rotation comes from these. None: there are none. closed: that of the arm.
std::optional<ArmValues> jointsOfConfiguration(const WantedConfiguration& wanted, const SerialArm& arm,
                                               const ClosedFormIk& closed, const Pose& tip,
                                               std::span<const ArmValues> references);

}  // namespace handwheel
