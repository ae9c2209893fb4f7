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

// Moves a waypoint towards the straight motion between its neighbours, as far as both its motions stay free.
bool pullTight(const RobotScene& scene, JointPath& path, std::size_t i, const MotionCheckSettings& check,
               const Progress& progress) {
  const double before = lengthOf(scene, path[i - 1], path[i]), after = lengthOf(scene, path[i], path[i + 1]);
  if (!(before + after > 0.0)) return false;
  const ArmValues chord = path[i - 1] + before / (before + after) * (path[i + 1] - path[i - 1]);
  for (const double share : {0.8, 0.4, 0.1}) {
    const ArmValues moved = path[i] + share * (chord - path[i]);
    const double now = lengthOf(scene, path[i - 1], moved) + lengthOf(scene, moved, path[i + 1]);
    if (now > 0.999 * (before + after)) return false;
    if (!isFree(scene, path[i - 1], moved, check, progress) || !isFree(scene, moved, path[i + 1], check, progress))
      continue;
    path[i] = moved;
    return true;
  }
  return false;
}

// Lets one joint go evenly between two waypoints, where it wanders while others have to move.
bool straighten(const RobotScene& scene, JointPath& path, std::size_t i, std::size_t j, Eigen::Index joint,
                const MotionCheckSettings& check, const Progress& progress) {
  std::vector<double> along{0.0};
  for (std::size_t k = i + 1; k <= j; ++k) along.push_back(along.back() + lengthOf(scene, path[k - 1], path[k]));
  if (!(along.back() > 0.0)) return false;
  JointPath changed(path.begin() + static_cast<std::ptrdiff_t>(i), path.begin() + static_cast<std::ptrdiff_t>(j) + 1);
  for (std::size_t k = 1; k + 1 < changed.size(); ++k)
    changed[k][joint] = path[i][joint] + along[k] / along.back() * (path[j][joint] - path[i][joint]);
  if (lengthOf(scene, changed) > 0.99 * along.back()) return false;
  for (std::size_t k = 1; k < changed.size(); ++k) {
    if (!isFree(scene, changed[k - 1], changed[k], check, progress)) return false;
  }
  std::copy(changed.begin(), changed.end(), path.begin() + static_cast<std::ptrdiff_t>(i));
  return true;
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
    // Every third attempt lets one joint go evenly between two waypoints, or pulls a waypoint straight. The others are
    // shortcuts from a point on one motion to a point on another.
    if (round % 3 == 2) {
      const std::size_t from = random.below(path.size() - 2);
      const std::size_t to = from + 2 + random.below(path.size() - 2 - from);
      const auto joint = static_cast<Eigen::Index>(random.below(static_cast<std::size_t>(scene.size())));
      if (!straighten(scene, path, from, to, joint, check, progress)) pullTight(scene, path, from + 1, check, progress);
      continue;
    }
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
  // The rest is pulled straight as long as that gains something.
  const auto isLate = [&] { return std::chrono::duration<double>(Clock::now() - begin).count() > seconds; };
  for (int sweep = 0; sweep < rounds && path.size() > 2 && !progress.cancelled() && !isLate(); ++sweep) {
    const double before = lengthOf(scene, path);
    for (std::size_t i = 1; i + 1 < path.size() && !progress.cancelled() && !isLate(); ++i)
      pullTight(scene, path, i, check, progress);
    if (sweep % 4 == 3) leaveOut(scene, path, check, progress);
    constexpr double kWorthwhile = 0.995;
    if (lengthOf(scene, path) > kWorthwhile * before) break;
  }
  if (path.size() > 2) leaveOut(scene, path, check, progress);
  return path;
}

}  // namespace handwheel
