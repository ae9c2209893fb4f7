// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/Plan.h"

#include <algorithm>
#include <span>

namespace handwheel {

// An interval of a motion in which the robot violates a clearance.
struct PathCollision {
  std::size_t motion = 0;         // index of the motion
  double from = 0.0, to = 0.0;    // fractions of the motion
  RobotScene::Nearest deepest{};  // the pair with the least distance
  double deepestAt = 0.0;         // position of the least distance, as a fraction of the motion
};

// The result of the verification of a path.
struct VerifiedPath {
  std::vector<bool> certified;  // for each motion: true if it is proven free at all its points
  // The collisions in order, including intervals that are only too near to something to be proven free.
  std::vector<PathCollision> collisions;
  std::uint64_t steps = 0;  // number of points that were checked

  bool isCertified() const { return std::find(certified.begin(), certified.end(), false) == certified.end(); }
};

// The default of the setting verify.step; rad of a joint.
inline constexpr double kVerificationStep = 0.01;

// Verifies a whole path and lists all collisions, each pair of objects separately. Each motion is proven free
// (MotionCheck). If the proof fails, the motion is sampled every `step` (rad of a joint; for slides a metre counts as a
// radian) and at the point where the proof failed. A path of one waypoint counts as one motion. offs: the deviation of
// points of the robot in each motion, mm; empty: no deviation. The result is incomplete after a cancellation.
VerifiedPath verified(const RobotScene& scene, const JointPath& path, const MotionCheckSettings& check,
                      double step = kVerificationStep, Progress progress = {}, std::span<const double> offs = {});

}  // namespace handwheel
