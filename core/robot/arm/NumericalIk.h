// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/RandomSequence.h"
#include "robot/arm/SerialArm.h"

namespace handwheel {

// Settings of numerical inverse kinematics.
struct NumericalIkSettings {
  double tolerance = 1e-5;  // rad, and of lengths to `length`; for each of the six numbers of the error
  double length = 1000.0;   // mm: lengths are divided by it before they meet angles (1000: they are metres)
  double seconds = 5e-3;    // after which no further start is tried
  std::uint32_t mostStarts = 1'000'000;  // the given one, and random ones within the limits
  std::uint64_t seed = 1;                // of the random starts
  double turnWeight = 1.0;               // of the turn of the tip beside its place; 0: only the place counts
};

// What became of it.
struct NumericalIkResult {
  bool isSolved = false;
  ArmValues values;          // the best that was found, within the limits
  double distance = 0.0;     // mm, that the tip is off
  double angle = 0.0;        // rad
  std::uint32_t starts = 0;  // that were tried
  std::uint32_t iterations = 0;
};

// Finds joint values that bring the tip to a pose of the base, near to those given, by damped least squares: the error
// enters the damping (Chan and Lawrence 1988; Sugihara 2011), so that it stays calm where the arm is stretched or
// folded. Joints are kept within their limits, and turned by whole turns where that brings them there. From where it
// does not get any nearer it starts again elsewhere. Works for arms of any number of joints; those that cannot reach
// all poses end as near as they get. Allocates nothing. O(iterations · joints³).
NumericalIkResult solvedNumerically(const SerialArm& arm, const Pose& tip, const ArmValues& start,
                                    const NumericalIkSettings& settings = {}, Progress progress = {});

// Fewer joints reach places, not poses.
inline constexpr Eigen::Index kJointsOfAnyPose = 6;

// The same for an arm that cannot reach all poses: brings the tip to the place of the pose, turned as near to it as
// this lets it be, from the start that is given; from random ones, anyhow. Solved: it is at the place.
NumericalIkResult solvedForPlace(const SerialArm& arm, const Pose& tip, const ArmValues& start,
                                 const NumericalIkSettings& settings = {}, Progress progress = {});

// Random values within the limits; where there are none, of turns within a half, of slides within the arm's reach.
void fillWithRandom(const SerialArm& arm, RandomSequence& sequence, ArmValues& values);

// The error of a pose: of the place (mm), and the turn from `at` to `wanted` as an axis of its angle's length (rad),
// both in the frame of the base.
Eigen::Matrix<double, 6, 1> poseError(const Pose& at, const Pose& wanted);

}  // namespace handwheel
