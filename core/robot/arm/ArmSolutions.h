// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/ClosedFormIk.h"

#include <vector>

namespace handwheel {

// A solution of the inverse kinematics of an arm.
struct ArmSolution {
  ArmValues values;                         // shifted by whole turns as near to the reference as the limits allow
  std::optional<Eigen::Index> beyond = {};  // the first joint that would exceed its limits
  std::optional<ArmConfiguration> configuration = {};  // for arms with a closed form
  double turnedOff = 0.0;  // rad between the tip and the pose: for arms that reach positions, not poses
  double distance = 0.0;   // mm: displacement of the joints in space from the reference (He 2008, equation 6-14)
};

// Largest number of solutions without a closed form: an arm with more than six joints has infinitely many.
inline constexpr std::size_t kMostNumericalSolutions = 8;

// Finds all solutions for a pose of the tip: those within the limits first, the nearest of them first. Arms without a
// closed form are solved from the reference and from random configurations, always the same ones; for these arms
// solutions beyond the limits are not found. An arm with fewer than six joints that cannot reach the pose reaches its
// position, with the nearest possible orientation. Empty: the pose is out of reach. O(1), or some milliseconds.
std::vector<ArmSolution> solutionsFor(const SerialArm& arm, const Pose& tip, const ArmValues& reference);

}  // namespace handwheel
