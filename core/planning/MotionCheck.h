// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/RobotScene.h"

#include <vector>

namespace handwheel {

// How motions are checked.
struct MotionCheckSettings {
  double clearance = 0.0;     // mm that the robot keeps from what stands around it, at least
  double ownClearance = 0.0;  // mm that its links keep from each other
  // mm: what comes nearer to the clearance than this is not distinguished from what does not keep it.
  double resolution = 0.05;

  bool operator==(const MotionCheckSettings&) const = default;
};

// The same for a robot whose points may be so far from where they are taken to be; mm.
inline MotionCheckSettings widened(MotionCheckSettings settings, double off) {
  settings.clearance += off;
  settings.ownClearance += 2.0 * off;  // two links may be off towards each other
  return settings;
}

// What blocks the robot at these values; no link: nothing does, and motions from there can be proven free.
RobotScene::Nearest blockerAt(const RobotScene& scene, const ArmValues& values, const MotionCheckSettings& settings,
                              QueryCounts* counts = nullptr);

// Whether nothing does.
bool isFreeAt(const RobotScene& scene, const ArmValues& values, const MotionCheckSettings& settings,
              QueryCounts* counts = nullptr);

// Proves that a straight motion in joint space is free of collisions. Or finds where it is not: nothing between two
// points of the motion is left to chance. At a point of the motion everything is so far from everything else; around it
// the motion is free as long as no point of a link can have moved further than that (Schwarzer, Saha and Latombe 2005,
// Adaptive dynamic collision checking for single and multiple articulated robots in complex environments; the bounds
// here are those of the places where the joints are, instead of the farthest ones). What is not covered yet is halved,
// the longest piece first.
//
// It can be done piece by piece, for planners that turn to another motion in between.
class MotionCheck {
 public:
  enum class State { Open, Free, Blocked };

  // The scene must outlive it. Values are those of its joints.
  MotionCheck(const RobotScene& scene, const ArmValues& from, const ArmValues& to, const MotionCheckSettings& settings);

  const ArmValues& from() const { return m_from; }
  const ArmValues& to() const { return m_to; }
  State state() const { return m_state; }
  // How far a point of the robot can move in the longest piece that is still open; mm. 0: none is.
  double openLength() const;

  // Looks at one point of the motion. O(pieces of the scene).
  State step(QueryCounts* counts = nullptr);
  // All that is needed; O(length of the motion / what is free around it) points. Open: it was cancelled before that.
  State run(const Progress& progress = {}, QueryCounts* counts = nullptr);

  // Of a motion that is blocked: where it was found, as a share of the motion, and what is too near there.
  double blockedAt() const { return m_blockedAt; }
  const RobotScene::Nearest& blockedBy() const { return m_blockedBy; }

  std::uint64_t steps() const { return m_steps; }

 private:
  struct Interval {
    double begin, end;       // shares of the motion
    std::uint64_t suspects;  // bits: those of m_suspects that are not known to be free in it
    bool operator<(const Interval& other) const { return end - begin < other.end - other.begin; }
  };
  // A look at the scene around a point of the motion.
  struct Look {
    RobotScene::Places places;
    double whole;  // half of the interval
    QueryCounts* counts;
  };
  double enough(double clearance, double speed, double half) const;
  bool cover(double distance, double clearance, double speed, double& half) const;
  // Of a group or a pair of groups: free in the whole interval; in no more than `half`, which is shortened to what is
  // free, on each side of its middle; or not free there.
  enum class Finding { Clear, Near, Blocked };
  Finding cover(const RobotScene::Group& group, const Look& look, double& half);
  Finding cover(const RobotScene::GroupPair& pair, const Look& look, double& half);
  Finding coverSubject(std::uint32_t subject, const Look& look, double& half);
  void open(const Interval& interval);

  const RobotScene* m_scene;
  ArmValues m_from, m_to, m_way;
  MotionCheckSettings m_settings;
  std::vector<Interval> m_open;           // a heap, the longest first
  std::vector<std::uint32_t> m_suspects;  // groups, then pairs of groups, that the first look left open
  State m_state = State::Open;
  double m_reach = 0.0;  // mm that a point moves about at most in the whole motion
  double m_blockedAt = 0.0;
  RobotScene::Nearest m_blockedBy{};
  std::uint64_t m_steps = 0;
};

}  // namespace handwheel
