// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/Plan.h"

namespace handwheel {

// The length of a straight motion in joint space; rad, slides in metres.
double lengthOf(const RobotScene& scene, const ArmValues& from, const ArmValues& to);
// The sum of the lengths of its motions in joint space; rad, slides in metres.
double lengthOf(const RobotScene& scene, const JointPath& path);

// Makes a free path shorter by motions straight from one of its places to another, as long as these are proven free.
// seconds: after which it ends; rounds: of one attempt each. Start and goal stay as they are, bit for bit.
JointPath shortened(const RobotScene& scene, JointPath path, const MotionCheckSettings& check, int rounds,
                    double seconds, std::uint64_t seed, Progress progress = {});

}  // namespace handwheel
