// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/RobotScene.h"

namespace handwheel {

// The scenarios of He (2008, section 3.2), by the distance of a robot from obstacles.
enum class ProximityScenario {
  Apart = 1,      // more than the tolerance
  Near = 2,       // less than the tolerance
  Colliding = 3,  // none
};
ProximityScenario scenarioOf(double distance, double tolerance);  // both in mm

// Returns joint values at which a robot is in a scenario. They are random within the limits, and the same each time.
// tolerance: mm. Returns nothing if none were found, or if it was cancelled.
std::optional<ArmValues> valuesInScenario(const RobotScene& scene, ProximityScenario scenario, double tolerance,
                                          Progress progress = {});

// The cost of one kind of query, which is asked at each step of a motion.
struct ProximityCost {
  double median = 0.0, slowest = 0.0;  // µs of CPU time, with the poses of all links
  double volumes = 0.0, pairs = 0.0;   // means of QueryCounts
};

// Costs and results of the four queries of He (2008): C1 the closest points, C2 whether anything is nearer than the
// tolerance, C3 whether anything collides, and C4 all contacts.
struct ProximityCosts {
  static constexpr std::size_t kQueries = 4;
  std::array<ProximityCost, kQueries> queries;
  double distance = 0.0;  // mm, at most 0 if the robot collides; infinite without obstacles
  bool isNear = false, isColliding = false;
  std::size_t contacts = 0;  // pairs of triangles or solids that meet

  ProximityScenario scenario = ProximityScenario::Apart;
};

// Measures the queries around joint values. The robot moves forth and back by a few millimetres, as the servo loop
// leads it. tolerance: mm. steps: the number of steps of the motion. The results are those at the values. Returns
// nothing if it was cancelled.
std::optional<ProximityCosts> measureProximity(const RobotScene& scene, const ArmValues& values, double tolerance,
                                               int steps, Progress progress = {});

// Parameters of a measurement.
struct ProximityRequest {
  double tolerance = 20.0;  // mm
  int steps = 200;
};

// The measurement in one scenario.
struct MeasuredScenario {
  std::optional<ProximityScenario> wanted;  // Nothing: the robot as it stands
  std::optional<ArmValues> values;          // Nothing: the robot does not get there
  std::optional<ProximityCosts> costs;      // Nothing: it does not get there, or the measurement was cancelled
};
// Measures the queries in a scenario. wanted: nothing for the scenario at the present joint values.
MeasuredScenario measuredScenario(const RobotScene& scene, const ArmValues& present,
                                  std::optional<ProximityScenario> wanted, const ProximityRequest& request,
                                  Progress progress = {});

}  // namespace handwheel
