// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/arm/ClosedFormIk.h"

#include <vector>

namespace handwheel {

// A way in which an arm reaches a pose.
struct ArmSolution {
  ArmValues values;                         // moved by whole turns as near to the reference as the limits let them be
  std::optional<Eigen::Index> beyond = {};  // the first joint that would have to be beyond its limits
  std::optional<ArmConfiguration> configuration = {};  // of arms with a closed form
  double turnedOff = 0.0;  // rad that the tip is turned off the pose: of arms that reach places, not poses
  double way = 0.0;        // mm from the reference: how far the joints are apart in space (He 2008, equation 6-14)
};

// The most ways that are looked for where there is no closed form: an arm with more than six joints has any number.
inline constexpr std::size_t kMostNumericalSolutions = 8;

// All ways in which an arm reaches a pose of its tip: those within the limits first, the nearest of them first. Arms
// without a closed form are solved from the reference and from random places, always the same ones; of these arms ways
// beyond the limits are not known. One with fewer than six joints that cannot reach the pose reaches its place, turned
// as near to it as that lets it be. Empty: the pose is out of reach. O(1), or some milliseconds.
std::vector<ArmSolution> solutionsFor(const SerialArm& arm, const Pose& tip, const ArmValues& reference);

}  // namespace handwheel
