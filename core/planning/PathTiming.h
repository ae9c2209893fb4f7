// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/Plan.h"

namespace handwheel {

// A time-optimal motion from rest to rest with limited velocity, acceleration and jerk. Double-S profile: Biagiotti and
// Melchiorri 2008, Trajectory Planning for Automatic Machines and Robots, section 3.4.
class RestToRest {
 public:
  // All above 0, but the distance, which may be 0.
  RestToRest(double distance, double velocity, double acceleration, double jerk);

  double duration() const { return 2.0 * m_ramp + m_cruise; }
  double timeOf(double way) const;  // s, when it is done; 0 to the distance
  double at(double time) const;     // the way done, 0 to the distance; before and after the motion these

 private:
  double rampAt(double time) const;  // the way done in the first ramp

  double m_distance, m_jerk;
  double m_turn = 0.0;    // s, with the jerk on, at each end of a ramp
  double m_ramp = 0.0;    // s, speeding up
  double m_cruise = 0.0;  // s
};

// How fast the joints of a robot may be.
struct PathTimingSettings {
  double speed = 1.0;         // share of the largest velocities, 0…1
  double turning = M_PI;      // rad/s of revolute joints whose velocity is not known, or 0
  double sliding = 500.0;     // mm/s of slides
  double timeToSpeed = 0.25;  // s from rest to the largest velocity, which gives the acceleration, whatever the speed
  double timeToRamp = 0.1;    // s until the acceleration is there: gives the jerk
};

// How a motion of a path is gone through.
struct MotionPace {
  double speed = 1.0;        // share of the largest velocities
  double length = 0.0;       // mm of the tool's way, where its speed is asked for; 0: the joints alone count
  double toolSpeed = 0.0;    // mm/s, then
  bool isContinued = false;  // the robot does not stop where the motion ends; its tool's speed goes on in the next
};

// A path in time: it stops at each place, but where a motion is continued.
class TimedPath {
 public:
  // paces: of each motion; empty: as fast as the joints can.
  TimedPath(const RobotScene& scene, JointPath path, const PathTimingSettings& settings,
            std::span<const MotionPace> paces = {});

  double duration() const { return m_begins.back(); }
  double beginOf(std::size_t motion) const { return m_begins[motion]; }  // also of the one after the last: the end
  std::size_t motionAt(double time) const;
  double shareAt(double time) const;      // of motionAt()
  ArmValues valuesAt(double time) const;  // the path must have a place
  const JointPath& path() const { return m_path; }

 private:
  // Motions from a stop to the next, with the way in mm of the tool, or in shares of a single motion.
  struct Run {
    std::size_t first;  // motion
    double begin;       // s
    RestToRest profile;
  };

  JointPath m_path;
  std::vector<Run> m_runs;
  std::vector<std::size_t> m_runOf;  // of each motion
  std::vector<double> m_ways;        // of each motion, in the measure of its run
  std::vector<double> m_waysBefore;  // of the motions before it in its run
  std::vector<double> m_begins;      // s; one more than motions
};

}  // namespace handwheel
