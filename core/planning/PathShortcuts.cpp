// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/PathShortcuts.h"

#include "base/RandomSequence.h"

#include <chrono>
#include <cmath>

namespace handwheel {

namespace {

bool isFree(const RobotScene& scene, const ArmValues& a, const ArmValues& b, const MotionCheckSettings& check,
            const Progress& progress) {
  return MotionCheck(scene, a, b, check).run(progress) == MotionCheck::State::Free;
}

// Removes each waypoint that its neighbours can do without, the longest spans first.
void leaveOut(const RobotScene& scene, JointPath& path, const MotionCheckSettings& check, const Progress& progress) {
  for (std::size_t span = path.size() - 1; span >= 2; --span) {
    for (std::size_t i = 0; i + span < path.size() && !progress.cancelled();) {
      if (!isFree(scene, path[i], path[i + span], check, progress)) {
        ++i;
        continue;
      }
      path.erase(path.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                 path.begin() + static_cast<std::ptrdiff_t>(i + span));
    }
  }
}

}  // namespace

double lengthOf(const RobotScene& scene, const ArmValues& from, const ArmValues& to) {
  double square = 0.0;
  for (Eigen::Index i = 0; i < from.size(); ++i) {
    const double difference = (to[i] - from[i]) * (scene.joint(i).isPrismatic ? 1e-3 : 1.0);
    square += difference * difference;
  }
  return std::sqrt(square);
}

double lengthOf(const RobotScene& scene, const JointPath& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) length += lengthOf(scene, path[i - 1], path[i]);
  return length;
}

JointPath shortened(const RobotScene& scene, JointPath path, const MotionCheckSettings& check, int rounds,
                    double seconds, std::uint64_t seed, Progress progress) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  if (path.size() < 3) return path;
  leaveOut(scene, path, check, progress);
  RandomSequence random(seed);
  for (int round = 0; round < rounds && path.size() > 2; ++round) {
    if (progress.cancelled() || std::chrono::duration<double>(Clock::now() - begin).count() > seconds) break;
    // A shortcut from a point on one motion to a point on another.
    std::size_t i = random.below(path.size() - 1), j = random.below(path.size() - 1);
    if (i == j) continue;
    if (i > j) std::swap(i, j);
    const ArmValues a = path[i] + random.share() * (path[i + 1] - path[i]);
    const ArmValues b = path[j] + random.share() * (path[j + 1] - path[j]);
    double before = lengthOf(scene, a, path[i + 1]) + lengthOf(scene, path[j], b);
    for (std::size_t k = i + 1; k < j; ++k) before += lengthOf(scene, path[k], path[k + 1]);
    if (lengthOf(scene, a, b) > 0.98 * before || !isFree(scene, a, b, check, progress)) continue;
    // The remaining pieces of the motions are parts of motions that are proven free.
    path.erase(path.begin() + static_cast<std::ptrdiff_t>(i) + 1, path.begin() + static_cast<std::ptrdiff_t>(j) + 1);
    path.insert(path.begin() + static_cast<std::ptrdiff_t>(i) + 1, {a, b});
  }
  return path;
}

}  // namespace handwheel
