// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "document/cell/CellScene.h"
#include "planning/RoutePlanning.h"
#include "tools/cell/path/PathCheck.h"

namespace handwheel {

// The parameters that say how a path is planned: "planner", "clearance", "resolution", "time", "shortcuts", "seed".
std::vector<Parameter> planningParameters();
// Begins with what the measured settings say.
void setFidelity(OperationValues& values, const FidelityValues& fidelity);

// The operation "plan": a path of the robot from one place through others to the last.
const Operation& planOperation();

// Joint values by the name of a configuration, "here" for where the robot stands, or a number for each joint between
// base and tool (rad, mm), separated by spaces or commas; or by the name of a target: then the nearest way to it that
// is free, from these joint values. Errors: PlaceMissing, ValueOutOfRange; those of poseOfTarget() and nearestFree().
Result<Waypoint> placeCalled(const CellScene& scene, const RobotCellSnapshot& cell, const std::string& text,
                             const JointValues& near);

// What errors call a place of a path: its name, or "place 2" of the one with the number 1 in it.
std::string nameOfPlace(const Waypoint& place, std::size_t number);

// The places that "from", "via" and "to" name; of targets, as near as may be to the place before, the first to where
// the robot stands. Errors: those of placeCalled().
Result<std::vector<Waypoint>> placesOf(const OperationValues& values, const CellScene& scene,
                                       const RobotCellSnapshot& cell);
// values: of an operation with the parameters above.
RouteSettings routeSettingsOf(const OperationValues& values, const CellPlans& plans);
// The same for the verification of what was planned; no coarser than others verify.
PathCheckSettings checkSettingsOf(const OperationValues& values, const CellPlans& plans, const RobotPath& path);

// A path that was planned. It is free between its places (MotionCheck).
struct PlannedPath {
  RobotPath path;
  double seconds = 0.0;
  std::uint64_t steps = 0;   // points that were looked at
  std::size_t keptLegs = 0;  // as they were
  bool isJagged = false;     // the curve that it follows (SurfaceTrack.h)
};

// Plans through these places, at least two. Those that were planned to targets go to where these are now. A leg between
// critical places that was planned between the same ends, and is still proven free, is kept; of others the places that
// are not critical are left out. Straight lines to a place stay lines. Errors: PlaceCollides, PlaceTooNear,
// PlaceBeyondLimits, OthersMoved, RouteNotFound, LineUnreachable, LineCollides, LineTooNear, PathTooShort, Cancelled;
// those of nearestFree() at targets that have moved.
Result<PlannedPath> plannedThrough(const CellScene& scene, const CellPlans& plans, std::span<const Waypoint> given,
                                   const RouteSettings& settings, Progress progress = {});

}  // namespace handwheel
