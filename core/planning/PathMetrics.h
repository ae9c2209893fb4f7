// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/Plan.h"

namespace handwheel {

// Settings for the measurement of a path.
struct PathMetricsSettings {
  double step = 0.02;  // rad: largest step of a joint between samples; for slides a metre counts as a radian
  std::size_t mostSamples = 2'000;  // the step is enlarged to respect this number, but all waypoints are sampled
  double farthest = 1'000.0;        // mm: limit of the measured distances
  double length = 0.0;              // mm that correspond to a radian in the manipulability; 0: the reach of the arm
};

// The measurements at a point of a path.
struct PathSample {
  double at = 0.0;         // position along the path, as a fraction of its length, 0…1
  std::size_t motion = 0;  // index of the motion between two waypoints
  double share = 0.0;      // position in this motion, as a fraction, 0…1
  ArmValues values;
  double clearance = 0.0;       // mm to the nearest obstacle; at most 0: a collision with an obstacle or between links
  double manipulability = 0.0;  // √det(J·Jᵀ), with lengths in units of PathMetricsSettings::length
  // Least margin of a joint from its limits, as a fraction of its range, 0…0.5; 0.5 without limits.
  double limitMargin = 0.0;
};

// The quality measures of a path.
struct PathMetrics {
  double length = 0.0;          // rad; for slides a metre counts as a radian
  double turned = 0.0;          // rad: length of the path of the joints that turn
  double slid = 0.0;            // mm: length of the path of the slides
  double manipulability = 0.0;  // mean over the samples (He 2008, equations 6-21 to 6-23)
  double leastManipulability = 0.0;
  // Harmonic mean of the clearances, mm (He 2008, equation 6-24); 0 if a clearance is not above 0.
  double security = 0.0;
  double leastClearance = 0.0;  // mm
  double leastMargin = 0.5;
  std::vector<PathSample> samples;  // in the order of the path
};

// Measures a path. The arm must have the joints of the scene. The result is incomplete after a cancellation. O(samples
// · cost of a distance query).
PathMetrics metricsOf(const RobotScene& scene, const SerialArm& arm, const JointPath& path,
                      const PathMetricsSettings& settings = {}, Progress progress = {});

// Returns the harmonic mean n / Σ(1/dᵢ) of clearances (He 2008, equation 6-24); 0 if a clearance is not above 0 or the
// list is empty.
double securityIndex(std::span<const double> clearances);

// Returns the manipulability √det(J·Jᵀ); for six joints this is |det J|. For fewer joints the result is √det(Jᵀ·J).
// length: the unit of length, mm.
double manipulabilityOf(const SerialArm& arm, const ArmValues& values, double length);

}  // namespace handwheel
