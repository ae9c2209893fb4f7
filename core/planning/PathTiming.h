// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/Plan.h"

namespace handwheel {

// A time-optimal motion from rest to rest with limited velocity, acceleration and jerk. Double-S profile: Biagiotti and
// Melchiorri 2008, Trajectory Planning for Automatic Machines and Robots, section 3.4.
class RestToRest {
 public:
  // All values must be above 0, except the distance, which may be 0.
  RestToRest(double distance, double velocity, double acceleration, double jerk);

  double duration() const { return 2.0 * m_ramp + m_cruise; }
  double timeOf(double distance) const;  // s at which this distance is covered; 0 to the whole distance
  double at(double time) const;          // the distance covered, clamped before and after the motion

 private:
  double rampAt(double time) const;  // the distance covered in the first ramp

  double m_distance, m_jerk;
  double m_turn = 0.0;    // s with constant jerk, at each end of a ramp
  double m_ramp = 0.0;    // s of acceleration
  double m_cruise = 0.0;  // s
};

// The limits of the velocities of a robot.
struct PathTimingSettings {
  double speed = 1.0;         // share of the largest velocities, 0…1
  double turning = M_PI;      // rad/s of revolute joints whose velocity is unknown or 0
  double sliding = 500.0;     // mm/s of slides
  double timeToSpeed = 0.25;  // s from rest to the largest velocity; determines the acceleration at any speed
  double timeToRamp = 0.1;    // s until the full acceleration; determines the jerk
};

// The speed of one motion of a path.
struct MotionPace {
  double speed = 1.0;      // share of the largest velocities
  double length = 0.0;     // mm: distance that the tool covers, if its speed is given; 0: only the joint speeds count
  double toolSpeed = 0.0;  // mm/s, if a length is given
  // The robot does not stop at the end of the motion; its tool keeps its speed in the next one.
  bool isContinued = false;
};

// A path in time. It stops at each waypoint, unless a motion is continued.
class TimedPath {
 public:
  // paces: one of each motion; empty: as fast as the joints can.
  TimedPath(const RobotScene& scene, JointPath path, const PathTimingSettings& settings,
            std::span<const MotionPace> paces = {});

  double duration() const { return m_begins.back(); }
  double beginOf(std::size_t motion) const { return m_begins[motion]; }  // also for the index after the last: the end
  std::size_t motionAt(double time) const;
  double shareAt(double time) const;      // share of motionAt()
  ArmValues valuesAt(double time) const;  // the path must have a waypoint
  const JointPath& path() const { return m_path; }

 private:
  // The motions from one stop to the next. Distances are in mm of the tool, or in shares of a single motion.
  struct Run {
    std::size_t first;  // motion
    double begin;       // s
    RestToRest profile;
  };

  JointPath m_path;
  std::vector<Run> m_runs;
  std::vector<std::size_t> m_runOf;       // run of each motion
  std::vector<double> m_distances;        // distance of each motion, in the unit of its run
  std::vector<double> m_distancesBefore;  // distance of the motions before it in its run
  std::vector<double> m_begins;           // s; one more than motions
};

}  // namespace handwheel
