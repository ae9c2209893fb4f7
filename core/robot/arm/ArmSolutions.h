// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/ClosedFormIk.h"

#include <vector>

namespace handwheel {

// A solution of the inverse kinematics of an arm.
struct ArmSolution {
  ArmValues values;  // joint values, shifted by whole turns as near to the reference as the limits allow
  std::optional<Eigen::Index> beyond = {};             // the first joint that would exceed its limits
  std::optional<ArmConfiguration> configuration = {};  // the configuration; only for arms with a closed form
  double turnedOff = 0.0;  // rad: orientation error of the tip, for arms that can reach a position but not a pose
  double distance = 0.0;   // mm: distance of the joints in space from the reference (He 2008, equation 6-14)
};

// Largest number of solutions for an arm without a closed form. An arm with more than six joints has infinitely many.
inline constexpr std::size_t kMostNumericalSolutions = 8;

// Finds all solutions for a pose of the tip. Solutions within the limits come first, sorted by their distance from the
// reference. Arms without a closed form are solved from the reference and from random configurations, which are the
// same in each call; for these arms solutions beyond the limits are not found. If an arm with fewer than six joints
// cannot reach the pose, its tip is brought to the position of the pose, with the nearest possible orientation. The
// result is empty if the pose is out of reach. O(1) with a closed form, otherwise some milliseconds.
std::vector<ArmSolution> solutionsFor(const SerialArm& arm, const Pose& tip, const ArmValues& reference);

}  // namespace handwheel
