// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/RandomSequence.h"
#include "robot/arm/SerialArm.h"

namespace handwheel {

// Settings of numerical inverse kinematics.
struct NumericalIkSettings {
  double tolerance = 1e-5;  // limit of each component of poseError(); rad, and lengths relative to `length`
  double length = 1000.0;   // mm: divisor of lengths that makes them comparable to angles (1000: metres)
  double seconds = 5e-3;    // time limit, after which no further start is tried
  std::uint32_t mostStarts = 1'000'000;  // largest number of starts: the given one, then random ones within the limits
  std::uint64_t seed = 1;                // seed of the random starts
  double turnWeight =
      1.0;  // weight of the orientation of the tip relative to its position; 0: only the position counts
};

// The result of numerical inverse kinematics.
struct NumericalIkResult {
  bool isSolved = false;
  ArmValues values;          // the best values found, within the limits
  double distance = 0.0;     // position error of the tip, mm
  double angle = 0.0;        // orientation error, rad
  std::uint32_t starts = 0;  // number of starts that were tried
  std::uint32_t iterations = 0;
};

// Finds joint values that bring the tip to a pose in the frame of the base, near the given values, by damped least
// squares. The damping depends on the error (Chan and Lawrence 1988; Sugihara 2011), so that the joints move little
// while the arm is stretched or folded. Joints are kept within their limits, and shifted by whole turns if that brings
// them within the limits. If a search makes no more progress, another one begins at a random start. The function works
// for any number of joints; for arms that cannot reach the pose it returns the nearest values found. It allocates
// nothing. O(iterations · joints³).
NumericalIkResult solvedNumerically(const SerialArm& arm, const Pose& tip, const ArmValues& start,
                                    const NumericalIkSettings& settings = {}, Progress progress = {});

// Least number of joints of an arm that can reach any pose near it. For arms with fewer joints that cannot reach a
// pose, solvedForPosition() is used.
inline constexpr Eigen::Index kJointsOfAnyPose = 6;

// Finds joint values for an arm that cannot reach all poses. They bring the tip to the position of the pose. From the
// given start the orientation is the nearest possible one, from random starts it is arbitrary. isSolved refers to the
// position only.
NumericalIkResult solvedForPosition(const SerialArm& arm, const Pose& tip, const ArmValues& start,
                                    const NumericalIkSettings& settings = {}, Progress progress = {});

// Fills in random values within the limits. A joint without limits gets a value within half a turn, a slide without
// limits one within the reach of the arm.
void fillWithRandom(const SerialArm& arm, RandomSequence& sequence, ArmValues& values);

// Returns the error of a pose in the frame of the base: the error of the position (mm), and the rotation from `at` to
// `wanted` as an axis whose length is the angle (rad).
Eigen::Matrix<double, 6, 1> poseError(const Pose& at, const Pose& wanted);

}  // namespace handwheel
