// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/Plan.h"
#include "planning/TimedRun.h"
#include "robot/program/AssumedRates.h"

namespace handwheel {

// The limits of the motion of a robot.
struct PathTimingSettings : AssumedRates {
  double speed = 1.0;  // fraction of the largest velocities, 0…1
};

// The speed of one motion of a path.
struct MotionPace {
  double speed = 1.0;      // fraction of the largest velocities
  double length = 0.0;     // mm: distance that the tool covers; 0: it does not move, or it is not known
  double toolSpeed = 0.0;  // mm/s: limit of the speed of the tool, if a length is given; 0: only the joint speeds count
  // The robot does not stop at the end of the motion.
  bool isContinued = false;
  // mm: distance from the end of the motion, before and behind it, within which the robot may leave the path; 0: a
  // stop, or a point of a line if the motion is continued.
  double zone = 0.0;
};

// A path in time, as an estimate: controllers plan by models of the robot that only they have. The robot stops at each
// waypoint unless the motion is continued. Between stops without zones no joint exceeds its velocity, acceleration or
// jerk; with zones no joint exceeds its velocity or acceleration.
class TimedPath {
 public:
  // Computes the times of a path. paces: one for each motion; empty: as fast as the joints can move.
  TimedPath(const RobotScene& scene, JointPath path, const PathTimingSettings& settings,
            std::span<const MotionPace> paces = {});

  double duration() const { return m_begins.back(); }
  // Returns the time at which a motion begins, s. The index after the last motion gives the end of the path.
  double beginOf(std::size_t motion) const { return m_begins[motion]; }
  std::size_t motionAt(double time) const;
  double shareAt(double time) const;      // position in the motion motionAt(), as a fraction
  ArmValues valuesAt(double time) const;  // the path must have a waypoint
  const JointPath& path() const { return m_path; }

 private:
  struct Run {
    double begin;  // s
    TimedRun motions;
  };

  void addRun(std::size_t first, std::size_t end, const JointRates& most, const PathTimingSettings& settings,
              std::span<const MotionPace> paces);

  JointPath m_path;
  std::vector<Run> m_runs;
  std::vector<std::size_t> m_runOf;     // run of each motion
  std::vector<double> m_extents;        // extent of each motion in its run
  std::vector<double> m_extentsBefore;  // sum of the extents of the preceding motions in the same run
  std::vector<double> m_begins;         // s; one more than motions
};

}  // namespace handwheel
