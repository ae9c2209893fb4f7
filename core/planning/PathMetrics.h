// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/Plan.h"

namespace handwheel {

// Settings of the measurement of a path.
struct PathMetricsSettings {
  double step = 0.02;  // largest step of a joint between samples, rad; for slides a metre counts as a radian
  std::size_t mostSamples = 2'000;  // the step grows to respect this number; waypoints are always sampled
  double farthest = 1'000.0;        // mm: limit of the measured distances
  double length = 0.0;              // mm that correspond to a radian in manipulability; 0: the reach of the arm
};

// The measurements at a point of a path.
struct PathSample {
  double at = 0.0;         // share of the length of the path, 0…1
  std::size_t motion = 0;  // from 0
  double share = 0.0;      // share of that motion
  ArmValues values;
  double clearance = 0.0;       // mm, from obstacles; at most 0: a collision, also between links
  double manipulability = 0.0;  // √det(J·Jᵀ), lengths in units of PathMetricsSettings::length
  double limitMargin = 0.0;  // margin of the joint nearest to a limit: share of its range, 0…0.5; 0.5 without limits
};

// The quality measures of a path.
struct PathMetrics {
  double length = 0.0;          // rad, slides in metres
  double manipulability = 0.0;  // mean (He 2008, equations 6-21 to 6-23)
  double leastManipulability = 0.0;
  double security = 0.0;        // mm: harmonic mean of the clearances (equation 6-24); 0 if any is not above 0
  double leastClearance = 0.0;  // mm
  double leastMargin = 0.5;
  std::vector<PathSample> samples;  // in order
};

// Measures a path. The arm must have the joints of the scene. Incomplete after a cancellation. O(samples · distance).
PathMetrics metricsOf(const RobotScene& scene, const SerialArm& arm, const JointPath& path,
                      const PathMetricsSettings& settings = {}, Progress progress = {});

// Returns n / Σ(1/dᵢ); 0 if any is not above 0, or there are none (equation 6-24).
double securityIndex(std::span<const double> clearances);

// Returns √det(J·Jᵀ), or |det J| for six joints; for fewer than six joints √det(Jᵀ·J). length: mm.
double manipulabilityOf(const SerialArm& arm, const ArmValues& values, double length);

}  // namespace handwheel
