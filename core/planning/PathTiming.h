// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/Plan.h"

namespace handwheel {

// A time-optimal motion from rest to rest with limited velocity, acceleration and jerk. It has a double-S profile
// (Biagiotti and Melchiorri 2008, Trajectory Planning for Automatic Machines and Robots, section 3.4).
class RestToRest {
 public:
  // Computes the motion over a distance within these limits. All values must be above 0, except the distance, which may
  // be 0.
  RestToRest(double distance, double velocity, double acceleration, double jerk);

  double duration() const { return 2.0 * m_ramp + m_cruise; }
  double timeOf(double distance) const;  // time at which a distance is covered, s; 0 ≤ distance ≤ the whole distance
  double at(double time) const;          // distance covered at a time, clamped before and after the motion

 private:
  double rampAt(double time) const;  // distance covered at a time in the first ramp

  double m_distance, m_jerk;
  double m_turn = 0.0;    // s with constant jerk, at each end of a ramp
  double m_ramp = 0.0;    // s of acceleration
  double m_cruise = 0.0;  // s
};

// The limits of the motion of a robot.
struct PathTimingSettings {
  double speed = 1.0;         // fraction of the largest velocities, 0…1
  double turning = M_PI;      // rad/s: velocity of revolute joints whose velocity is unknown or 0
  double sliding = 500.0;     // mm/s: velocity of slides whose velocity is unknown or 0
  double timeToSpeed = 0.25;  // s from rest to the largest velocity; determines the acceleration, whatever the speed
  double timeToRamp = 0.1;    // s until the full acceleration; determines the jerk
};

// The speed of one motion of a path.
struct MotionPace {
  double speed = 1.0;      // fraction of the largest velocities
  double length = 0.0;     // mm: distance that the tool covers, if toolSpeed is given; 0: only the joint speeds count
  double toolSpeed = 0.0;  // mm/s: limit of the speed of the tool, if a length is given
  // The robot does not stop at the end of the motion; its tool keeps its speed in the next one.
  bool isContinued = false;
};

// A path in time. The robot stops at each waypoint unless the motion is continued.
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
  // The motions from one stop to the next. Distances are in mm along the tool's path, or in fractions of a single
  // motion.
  struct Run {
    std::size_t first;  // index of the first motion
    double begin;       // s
    RestToRest profile;
  };

  JointPath m_path;
  std::vector<Run> m_runs;
  std::vector<std::size_t> m_runOf;       // run of each motion
  std::vector<double> m_distances;        // distance of each motion, in the unit of its run
  std::vector<double> m_distancesBefore;  // sum of the distances of the preceding motions in the same run
  std::vector<double> m_begins;           // s; one more than motions
};

}  // namespace handwheel
