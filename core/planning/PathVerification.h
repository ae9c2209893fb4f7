// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/Plan.h"

#include <algorithm>
#include <span>

namespace handwheel {

// A stretch of a motion in which the robot is too near to something.
struct PathCollision {
  std::size_t motion = 0;         // from 0
  double from = 0.0, to = 0.0;    // shares of the motion
  RobotScene::Nearest deepest{};  // where it is nearest, and to what
  double deepestAt = 0.0;         // share of the motion
};

// What the verification of a path has found.
struct VerifiedPath {
  std::vector<bool> certified;            // by motion: proven free between its points
  std::vector<PathCollision> collisions;  // in order; also where a motion is only too near to be proven free
  std::uint64_t steps = 0;                // points that were looked at

  bool isCertified() const { return std::find(certified.begin(), certified.end(), false) == certified.end(); }
};

// rad of a joint: the setting verify.step.
inline constexpr double kVerificationStep = 0.01;

// Verifies all of a path and does not stop at what it finds: each motion is proven free (MotionCheck), or is looked at
// every `step` (rad of a joint, slides a metre a radian) and where the proof failed; all that collides is listed, each
// pair by itself. A path of one place counts as one motion. offs: mm, of each motion, by which points of the robot may
// be off it; empty: by nothing. Incomplete once cancelled.
VerifiedPath verified(const RobotScene& scene, const JointPath& path, const MotionCheckSettings& check,
                      double step = kVerificationStep, Progress progress = {}, std::span<const double> offs = {});

}  // namespace handwheel
