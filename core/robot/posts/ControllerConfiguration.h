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
  bool isElbowDown = false;  // the wrist is behind the line from the second to the third axis
  bool isFlipped = false;    // the fifth joint is below 0
};

// Returns the configuration of an arm of six revolute joints.
ControllerConfiguration controllerConfigurationOf(const SerialArm& arm, const ArmValues& values);

// Returns the closed form of an arm with a spherical wrist, whose solutions a ControllerConfiguration distinguishes.
// Returns nothing for other arms.
std::optional<ClosedFormIk> closedFormOfSphericalWrist(const SerialArm& arm);

// Returns joint values as the controller of an arm counts them (SerialArm::coupling()), and back.
ArmValues countedByController(const SerialArm& arm, ArmValues values);
ArmValues countedByModel(const SerialArm& arm, ArmValues values);

// Returns true if a linkage keeps the upper arm level while the second joint moves, as in some robots of ABB.
bool hasParallelLinkage(const SerialArm& arm);

// Orientation error of the tip, rad, that the rounding of poses in files may cause.
inline constexpr double kPoseRounding = 1e-4;

// Returns true if axis 5 is so near 0 that a pose of a file determines only the sum of the angles of the axes 4 and 6.
bool isWristInLine(const ArmValues& values);

// Returns the error of a joint, rad, that the rounding of a pose in a file may cause. For the axes 4 and 6 the error
// grows as they come near to being in line; it is not defined if they are in line.
double jointRounding(const ArmValues& values, Eigen::Index joint);

// The conditions on the joint values of a solution.
struct WantedConfiguration {
  // Accepts the value of a joint with its whole turns. Arguments: the index of the joint, its value and the tolerance
  // of the value, rad.
  std::function<bool(Eigen::Index, double, double)> takesJoint;
  std::function<bool(const ArmValues&)> takes;  // accepts the values of all joints together
};

// Finds the accepted joint values within the limits that bring the tip of the arm to a pose within the rounding of
// files. If there are several solutions, the one nearest to the first reference is returned. If that reference yields
// none, the others are tried: if two axes are in line, the reference determines how the rotation is divided between
// them. Returns nothing if there is no solution. closed: the closed form of the arm.
std::optional<ArmValues> jointsOfConfiguration(const WantedConfiguration& wanted, const SerialArm& arm,
                                               const ClosedFormIk& closed, const Pose& tip,
                                               std::span<const ArmValues> references);

}  // namespace handwheel
