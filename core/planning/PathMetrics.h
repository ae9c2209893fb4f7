// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/Plan.h"

namespace handwheel {

// How a path is measured.
struct PathMetricsSettings {
  double step = 0.02;               // rad of a joint between samples, at most; slides count a metre as a radian
  std::size_t mostSamples = 2'000;  // the step grows where there would be more; the places are always sampled
  double farthest = 1'000.0;        // mm: what is further away counts as that far
  double length = 0.0;              // mm that stands for a radian in manipulability; 0: the reach of the arm
};

// What is measured at a point of a path.
struct PathSample {
  double at = 0.0;         // share of the path's length, 0…1
  std::size_t motion = 0;  // from 0
  double share = 0.0;      // of that motion
  ArmValues values;
  double clearance = 0.0;       // mm, from obstacles; at most 0: collision, with a link of its own, too
  double manipulability = 0.0;  // √det(J·Jᵀ), lengths in units of PathMetricsSettings::length
  double limitMargin = 0.0;     // of the joint nearest to a limit: share of its range, 0…0.5; 0.5 without limits
};

// What planners ask of a path.
struct PathMetrics {
  double length = 0.0;          // rad, slides in metres
  double manipulability = 0.0;  // mean (He 2008, equations 6-21 to 6-23)
  double leastManipulability = 0.0;
  double security = 0.0;        // mm: harmonic mean of the clearances (equation 6-24); 0 where any is not above 0
  double leastClearance = 0.0;  // mm
  double leastMargin = 0.5;
  std::vector<PathSample> samples;  // in order
};

// Measures a path. The arm must have the joints of the scene. Incomplete once cancelled. O(samples · distance).
PathMetrics metricsOf(const RobotScene& scene, const SerialArm& arm, const JointPath& path,
                      const PathMetricsSettings& settings = {}, Progress progress = {});

// n / Σ(1/dᵢ); 0 where any is not above 0, or there are none (equation 6-24).
double securityIndex(std::span<const double> clearances);

// √det(J·Jᵀ), or |det J| of six joints; of an arm with fewer than six joints √det(Jᵀ·J). length: mm.
double manipulabilityOf(const SerialArm& arm, const ArmValues& values, double length);

}  // namespace handwheel
