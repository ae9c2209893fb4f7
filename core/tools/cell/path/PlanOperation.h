// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "document/cell/CellScene.h"
#include "planning/RoutePlanning.h"
#include "tools/cell/path/PathCheck.h"

namespace handwheel {

// Returns the parameters of planning: "planner", "clearance", "resolution", "time", "shortcuts", "seed".
std::vector<Parameter> planningParameters();
// Sets the values "resolution" and "shortcuts" to the present fidelity settings.
void setFidelity(OperationValues& values, const FidelityValues& fidelity);

// Returns the operation "plan": a path of the robot from one waypoint through others to the last.
const Operation& planOperation();

// Returns the waypoint that a text names. The text is the name of a configuration, "here" for the present joint values,
// or a number for each joint between base and tool (rad, mm), separated by spaces or commas. The name of a target gives
// the free solution of the target that is nearest to `near`. Errors: WaypointMissing, ValueOutOfRange, and the errors
// of poseOfTarget() and nearestFree().
Result<Waypoint> waypointCalled(const CellScene& scene, const RobotCellSnapshot& cell, const std::string& text,
                                const JointValues& near);

// Returns the name of a waypoint for errors. A waypoint without a name is called by its number in the list, counted
// from 1.
std::string nameOfWaypoint(const Waypoint& waypoint, std::size_t number);

// Returns the waypoints that "from", "via" and "to" name. A target gives the solution nearest to the preceding
// waypoint; if the target is the first waypoint, the solution nearest to the present joint values. Errors: the errors
// of waypointCalled().
Result<std::vector<Waypoint>> waypointsOf(const OperationValues& values, const CellScene& scene,
                                          const RobotCellSnapshot& cell);
// Returns the planning settings. values: the values of an operation that has the parameters of planningParameters().
RouteSettings routeSettingsOf(const OperationValues& values, const CellPlans& plans);
// Returns the settings for verifying a planned path. The resolution is never coarser than the default.
PathCheckSettings checkSettingsOf(const OperationValues& values, const CellPlans& plans, const RobotPath& path);

// A planned path. Its legs between waypoints are free of collisions (MotionCheck).
struct PlannedPath {
  RobotPath path;
  double seconds = 0.0;
  std::uint64_t steps = 0;   // Number of points tested
  std::size_t keptLegs = 0;  // Number of unchanged legs
  bool isJagged = false;     // True if the path follows a jagged curve (SurfaceTrack.h)
};

// Plans a path through waypoints, at least two. A waypoint that was planned to a target moves to the present pose of
// the target. A leg between two critical waypoints is kept if it was planned between the same ends and is still proven
// free. Other legs are planned again without the waypoints that are not critical. Straight lines to a waypoint stay
// lines. Errors: WaypointCollides, WaypointTooNear, WaypointBeyondLimits, OthersMoved, RouteNotFound, LineUnreachable,
// LineCollides, LineTooNear, PathTooShort, Cancelled, and the errors of nearestFree() for targets that have moved.
Result<PlannedPath> plannedThrough(const CellScene& scene, const CellPlans& plans, std::span<const Waypoint> given,
                                   const RouteSettings& settings, Progress progress = {});

}  // namespace handwheel
