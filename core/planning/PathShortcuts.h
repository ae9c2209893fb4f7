// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/Plan.h"

namespace handwheel {

// Returns the length of a straight motion in joint space; rad, slides in metres.
double lengthOf(const RobotScene& scene, const ArmValues& from, const ArmValues& to);
// Returns the sum of the lengths of its motions in joint space; rad, slides in metres.
double lengthOf(const RobotScene& scene, const JointPath& path);

// Shortens a free path by straight motions between two of its points, as long as these are proven free. seconds: time
// limit; rounds: number of attempts. Start and goal stay as they are, bit for bit.
JointPath shortened(const RobotScene& scene, JointPath path, const MotionCheckSettings& check, int rounds,
                    double seconds, std::uint64_t seed, Progress progress = {});

}  // namespace handwheel
