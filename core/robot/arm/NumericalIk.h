// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/RandomSequence.h"
#include "robot/arm/SerialArm.h"

namespace handwheel {

// Settings of numerical inverse kinematics.
struct NumericalIkSettings {
  double tolerance = 1e-5;  // rad, and lengths relative to `length`; for each of the six numbers of the error
  double length = 1000.0;   // mm: divisor of lengths that makes them comparable to angles (1000: metres)
  double seconds = 5e-3;    // time limit, after which no further start is tried
  std::uint32_t mostStarts = 1'000'000;  // the given one, and random ones within the limits
  std::uint64_t seed = 1;                // seed of the random starts
  double turnWeight =
      1.0;  // weight of the orientation of the tip relative to its position; 0: only the position counts
};

// The result of a numerical solution.
struct NumericalIkResult {
  bool isSolved = false;
  ArmValues values;          // the best values found, within the limits
  double distance = 0.0;     // position error of the tip, mm
  double angle = 0.0;        // orientation error, rad
  std::uint32_t starts = 0;  // number of starts that were tried
  std::uint32_t iterations = 0;
};

// Finds joint values that bring the tip to a pose of the base, near to those given, by damped least squares. The error
// enters the damping (Chan and Lawrence 1988; Sugihara 2011), so that it stays calm if the arm is stretched or folded.
// Joints are kept within their limits, and shifted by whole turns if that brings them there. If it gets no nearer it
// starts again elsewhere. Works for any number of joints; arms that cannot reach all poses end as near as they get.
// Allocates nothing. O(iterations · joints³).
NumericalIkResult solvedNumerically(const SerialArm& arm, const Pose& tip, const ArmValues& start,
                                    const NumericalIkSettings& settings = {}, Progress progress = {});

// Arms with fewer joints reach positions, not poses.
inline constexpr Eigen::Index kJointsOfAnyPose = 6;

// Solves for an arm that cannot reach all poses: brings the tip to the position of the pose, with the nearest possible
// orientation from the given start; from random starts, with any. Solved: it is at the position.
NumericalIkResult solvedForPosition(const SerialArm& arm, const Pose& tip, const ArmValues& start,
                                    const NumericalIkSettings& settings = {}, Progress progress = {});

// Fills in random values within the limits; without limits, within half a turn, and for slides within the arm's reach.
void fillWithRandom(const SerialArm& arm, RandomSequence& sequence, ArmValues& values);

// Returns the error of a pose: of the position (mm), and the rotation from `at` to `wanted` as an axis of the length of
// its angle (rad), both in the frame of the base.
Eigen::Matrix<double, 6, 1> poseError(const Pose& at, const Pose& wanted);

}  // namespace handwheel
