// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/RobotScene.h"

#include <vector>

namespace handwheel {

// Settings of the collision check of motions.
struct MotionCheckSettings {
  double clearance = 0.0;     // mm: least distance of the robot from its surroundings
  double ownClearance = 0.0;  // mm: least distance of its links from each other
  // mm: distances within this of the clearance are not distinguished from a violation.
  double resolution = 0.05;

  bool operator==(const MotionCheckSettings&) const = default;
};

// Returns the settings for a robot whose points may deviate this much from their computed positions, mm.
inline MotionCheckSettings widened(MotionCheckSettings settings, double off) {
  settings.clearance += off;
  settings.ownClearance += 2.0 * off;  // two links may deviate towards each other
  return settings;
}

// Returns the obstacle to the robot at these values; no link: there is none, and motions from there can be proven free.
RobotScene::Nearest blockerAt(const RobotScene& scene, const ArmValues& values, const MotionCheckSettings& settings,
                              QueryCounts* counts = nullptr);

// Returns true if blockerAt() finds nothing.
bool isFreeAt(const RobotScene& scene, const ArmValues& values, const MotionCheckSettings& settings,
              QueryCounts* counts = nullptr);

// Proves a straight motion in joint space free of collisions, or finds a collision. The proof covers all points
// between the samples. At a point of the motion all distances are computed; around it the motion is free as long as no
// point of a link can have moved further than that (Schwarzer, Saha and Latombe 2005, Adaptive dynamic collision
// checking for single and multiple articulated robots in complex environments; the bounds here are those at the present
// joint positions, instead of the farthest ones). The rest is halved, the longest interval first.
//
// It can be done step by step, for planners that turn to another motion in between.
class MotionCheck {
 public:
  enum class State { Open, Free, Blocked };

  // The scene must outlive it. The values are those of its joints.
  MotionCheck(const RobotScene& scene, const ArmValues& from, const ArmValues& to, const MotionCheckSettings& settings);

  const ArmValues& from() const { return m_from; }
  const ArmValues& to() const { return m_to; }
  State state() const { return m_state; }
  // Returns the travel bound of a point of the robot in the longest open interval; mm. 0: no interval is open.
  double openLength() const;

  // Checks one point of the motion. O(pieces of the scene).
  State step(QueryCounts* counts = nullptr);
  // Checks until the state is known; O(length of the motion / free distance around it) points. Open: it was cancelled.
  State run(const Progress& progress = {}, QueryCounts* counts = nullptr);

  // The position of the collision of a blocked motion, as a share of the motion.
  double blockedAt() const { return m_blockedAt; }
  const RobotScene::Nearest& blockedBy() const { return m_blockedBy; }

  std::uint64_t steps() const { return m_steps; }

 private:
  struct Interval {
    double begin, end;       // shares of the motion
    std::uint64_t suspects;  // bits: the members of m_suspects that are not known to be free in it
    bool operator<(const Interval& other) const { return end - begin < other.end - other.begin; }
  };
  // A query of the scene around a point of the motion.
  struct Look {
    RobotScene::Poses poses;
    double whole;  // half of the interval
    QueryCounts* counts;
  };
  double enough(double clearance, double speed, double half) const;
  bool cover(double distance, double clearance, double speed, double& half) const;
  // State of a group or a pair of groups: free in the whole interval; free only within `half`, which is reduced to the
  // free part on each side of the middle; or not free at the middle.
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
