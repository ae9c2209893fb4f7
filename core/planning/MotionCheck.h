// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/RobotScene.h"

#include <vector>

namespace handwheel {

// Settings of the collision check of motions.
struct MotionCheckSettings {
  double clearance = 0.0;     // mm: least allowed distance of the robot from its surroundings
  double ownClearance = 0.0;  // mm: least allowed distance of its links from each other
  // mm: distances that exceed the clearance by less than this may count as a violation.
  double resolution = 0.05;

  bool operator==(const MotionCheckSettings&) const = default;
};

// Returns the settings for a robot whose points may deviate this much from their computed positions, mm.
inline MotionCheckSettings widened(MotionCheckSettings settings, double off) {
  settings.clearance += off;
  settings.ownClearance += 2.0 * off;  // two links may deviate towards each other
  return settings;
}

// Returns the pair that violates its clearance most at these values, with a margin of half the resolution. If there is
// no such pair, the link of the result is kNone, and motions from these values can be proven free.
RobotScene::Nearest blockerAt(const RobotScene& scene, const ArmValues& values, const MotionCheckSettings& settings,
                              QueryCounts* counts = nullptr);

// Returns true if blockerAt() finds nothing.
bool isFreeAt(const RobotScene& scene, const ArmValues& values, const MotionCheckSettings& settings,
              QueryCounts* counts = nullptr);

// A proof that a straight motion in joint space is free of collisions. If there is a collision, the search for the
// proof finds it. All distances are computed at a point of the motion; around this point the motion is free as long as
// no point of a link can have moved further than the distance of the link from other objects (Schwarzer, Saha and
// Latombe 2005, Adaptive dynamic collision checking for single and multiple articulated robots in complex environments;
// unlike there, the speed of the links is bounded for the joint values near this point, not for all joint values). What
// remains of the motion is divided into intervals, which are checked in the same way, the longest first. The proof
// covers all points of the motion.
//
// The proof can be found step by step, so that planners may continue with another motion in between.
class MotionCheck {
 public:
  enum class State { Open, Free, Blocked };

  // Begins the proof for the motion between two configurations of the scene's joints. The scene must outlive this
  // object.
  MotionCheck(const RobotScene& scene, const ArmValues& from, const ArmValues& to, const MotionCheckSettings& settings);

  const ArmValues& from() const { return m_from; }
  const ArmValues& to() const { return m_to; }
  State state() const { return m_state; }
  // Returns an upper bound of the travel of a point of the robot in the longest open interval, mm; 0: no interval is
  // open.
  double openLength() const;

  // Checks one point of the motion. O(pieces of the scene).
  State step(QueryCounts* counts = nullptr);
  // Checks points until the state is known. If the check is cancelled, the state stays Open. O(length of the motion /
  // free distance around it) points.
  State run(const Progress& progress = {}, QueryCounts* counts = nullptr);

  // Returns the position of the collision of a blocked motion, as a fraction of the motion.
  double blockedAt() const { return m_blockedAt; }
  const RobotScene::Nearest& blockedBy() const { return m_blockedBy; }

  std::uint64_t steps() const { return m_steps; }

 private:
  struct Interval {
    double begin, end;       // fractions of the motion
    std::uint64_t suspects;  // bit i: m_suspects[i] is not known to be free in the interval
    bool operator<(const Interval& other) const { return end - begin < other.end - other.begin; }
  };
  // A query of the scene around a point of the motion.
  struct Look {
    RobotScene::Poses poses;
    double whole;  // half of the length of the interval; the argument `half` of cover() is at most this
    QueryCounts* counts;
  };
  double enough(double clearance, double speed, double half) const;
  bool cover(double distance, double clearance, double speed, double& half) const;
  // State of a group or a pair of groups. Clear: free in the whole interval. Near: free only near the middle; the
  // argument `half` of cover() is reduced to the length that is free on each side of the middle. Blocked: not free at
  // the middle.
  enum class Finding { Clear, Near, Blocked };
  Finding cover(const RobotScene::Group& group, const Look& look, double& half);
  Finding cover(const RobotScene::GroupPair& pair, const Look& look, double& half);
  Finding coverSubject(std::uint32_t subject, const Look& look, double& half);
  void open(const Interval& interval);

  const RobotScene* m_scene;
  ArmValues m_from, m_to, m_displacement;
  MotionCheckSettings m_settings;
  std::vector<Interval> m_open;           // a heap, the longest first
  std::vector<std::uint32_t> m_suspects;  // groups, then pairs of groups, that the first query did not prove free
  State m_state = State::Open;
  double m_reach = 0.0;  // mm: approximate upper bound of the travel of a point in the whole motion
  double m_blockedAt = 0.0;
  RobotScene::Nearest m_blockedBy{};
  std::uint64_t m_steps = 0;
};

}  // namespace handwheel
