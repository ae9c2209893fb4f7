// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/Plan.h"

#include <algorithm>
#include <span>

namespace handwheel {

// An interval of a motion in which the robot is too near to something.
struct PathCollision {
  std::size_t motion = 0;         // from 0
  double from = 0.0, to = 0.0;    // shares of the motion
  RobotScene::Nearest deepest{};  // the pair with the least distance
  double deepestAt = 0.0;         // share of the motion
};

// The result of the verification of a path.
struct VerifiedPath {
  std::vector<bool> certified;            // by motion: proven free between its points
  std::vector<PathCollision> collisions;  // in order; includes motions that are only too near to be proven free
  std::uint64_t steps = 0;                // number of points that were checked

  bool isCertified() const { return std::find(certified.begin(), certified.end(), false) == certified.end(); }
};

// The setting verify.step: rad of a joint.
inline constexpr double kVerificationStep = 0.01;

// Verifies a whole path and does not stop at collisions. Each motion is proven free (MotionCheck), or else sampled
// every `step` (rad of a joint; for slides a metre counts as a radian) and at the point where the proof failed; all
// collisions are listed, each pair by itself. A path of one waypoint counts as one motion. offs: deviation of points of
// the robot in each motion, mm; empty: none. Incomplete after a cancellation.
VerifiedPath verified(const RobotScene& scene, const JointPath& path, const MotionCheckSettings& check,
                      double step = kVerificationStep, Progress progress = {}, std::span<const double> offs = {});

}  // namespace handwheel
