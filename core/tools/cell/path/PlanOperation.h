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
// Sets initial values from the measured settings.
void setFidelity(OperationValues& values, const FidelityValues& fidelity);

// Returns the operation "plan": a path of the robot from one waypoint through others to the last.
const Operation& planOperation();

// Returns a waypoint by the name of a configuration, "here" for the present joint values, or a number for each joint
// between base and tool (rad, mm), separated by spaces or commas; or by the name of a target: then its nearest free
// solution. Errors: WaypointMissing, ValueOutOfRange; those of poseOfTarget() and nearestFree().
Result<Waypoint> waypointCalled(const CellScene& scene, const RobotCellSnapshot& cell, const std::string& text,
                                const JointValues& near);

// Returns the name of a waypoint for errors: its own, or "place 2" for the one with index 1.
std::string nameOfWaypoint(const Waypoint& waypoint, std::size_t number);

// Returns the waypoints that "from", "via" and "to" name; for a target the solution nearest to the preceding waypoint,
// for the first one to the present joint values. Errors: those of waypointCalled().
Result<std::vector<Waypoint>> waypointsOf(const OperationValues& values, const CellScene& scene,
                                          const RobotCellSnapshot& cell);
// Returns the settings. values: of an operation with the parameters above.
RouteSettings routeSettingsOf(const OperationValues& values, const CellPlans& plans);
// Returns the settings for verifying a planned path; no coarser than the default.
PathCheckSettings checkSettingsOf(const OperationValues& values, const CellPlans& plans, const RobotPath& path);

// A planned path. It is free between its waypoints (MotionCheck).
struct PlannedPath {
  RobotPath path;
  double seconds = 0.0;
  std::uint64_t steps = 0;   // Number of points tested
  std::size_t keptLegs = 0;  // Number of unchanged legs
  bool isJagged = false;     // True if the curve that it follows is jagged (SurfaceTrack.h)
};

// Plans through these waypoints, at least two. Those planned to targets go to the present poses of these. A leg between
// critical waypoints that was planned between the same ends, and is still proven free, is kept; in others, waypoints
// that are not critical are left out. Straight lines to a waypoint stay lines. Errors: WaypointCollides,
// WaypointTooNear, WaypointBeyondLimits, OthersMoved, RouteNotFound, LineUnreachable, LineCollides, LineTooNear,
// PathTooShort, Cancelled; those of nearestFree() at targets that have moved.
Result<PlannedPath> plannedThrough(const CellScene& scene, const CellPlans& plans, std::span<const Waypoint> given,
                                   const RouteSettings& settings, Progress progress = {});

}  // namespace handwheel
