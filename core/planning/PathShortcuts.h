// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/Plan.h"

namespace handwheel {

// Returns the length of a straight motion in joint space. The unit is rad; for slides a metre counts as a radian.
double lengthOf(const RobotScene& scene, const ArmValues& from, const ArmValues& to);
// Returns the sum of the lengths of the motions of a path. The unit is rad; for slides a metre counts as a radian.
double lengthOf(const RobotScene& scene, const JointPath& path);

// Shortens a free path by straight motions between two of its points, if these motions are proven free. The start and
// the goal stay exactly the same. rounds: the number of attempts. seconds: the time limit.
JointPath shortened(const RobotScene& scene, JointPath path, const MotionCheckSettings& check, int rounds,
                    double seconds, std::uint64_t seed, Progress progress = {});

}  // namespace handwheel
