// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The error codes of planning in a robot cell.
namespace handwheel::CellError {

extern const ErrorDescription WaypointMissing;       // {text}: no configuration, no target and no joint values
extern const ErrorDescription RobotUnknown;          // {text}: no robot of the program and no file with one
extern const ErrorDescription PathMissing;           // {path}: the name is no path of the cell and no file
extern const ErrorDescription PathTooShort;          // {path}: the path has fewer than two waypoints
extern const ErrorDescription WaypointCollides;      // {waypoint, link, link or body}: a collision at the waypoint
extern const ErrorDescription WaypointTooNear;       // {waypoint, link, link or body, mm}: too close at the waypoint
extern const ErrorDescription WaypointBeyondLimits;  // {waypoint, joint}: the joint is beyond its limits
extern const ErrorDescription RouteNotFound;         // {from, to, seconds}: no path was found in this time
extern const ErrorDescription OthersMoved;           // {waypoint}: a joint that is not planned, as of a finger, differs
extern const ErrorDescription LineUnreachable;       // {waypoint, percent}: the arm cannot follow the line
extern const ErrorDescription PoseUnreachable;       // {motion}: no joint values reach its end
extern const ErrorDescription CornerNotProven;       // {path, waypoint}: the controller rounds the corner there
extern const ErrorDescription CarriedUnknown;        // {path, waypoint, line of the program}: it may grip or release
extern const ErrorDescription PathCollides;          // {path, count, link, link or body}: the first of the collisions
extern const ErrorDescription ShapeMissing;          // {path, link or body, shape}: its shape could not be read
extern const ErrorDescription PathOutdated;          // {path, part}: the part with the curve of the path was moved
extern const ErrorDescription PathBaseMoved;         // {path}: the robot was moved since its curve was planned
extern const ErrorDescription PathToolChanged;       // {path}: its curve was planned with another tool
extern const ErrorDescription CoupledBeyondLimits;   // {joint, sign, other joint, degrees, lower, upper}
extern const ErrorDescription PathFrameMoved;        // {path, frame}: the program was read in another pose of it
extern const ErrorDescription PathTargetMoved;       // {path, target}: the tool does not reach the target any more
extern const ErrorDescription PathWaypointChanged;   // {path, configuration}: the configuration has changed
extern const ErrorDescription LineCollides;          // {waypoint, link, link or body}: a collision on the line
extern const ErrorDescription LineTooNear;           // {waypoint, link, link or body, mm}: too close on the line
extern const ErrorDescription PartCarried;           // {body}: the robot carries the body
extern const ErrorDescription TrackMissing;          // {body}: no curve was found at the chosen point
extern const ErrorDescription DrawnCurveBroken;      // {numbers of two points}: no surface connects the points
extern const ErrorDescription TrackOutOfReach;       // {point, count, x, y, z; mm}: the point is out of reach
extern const ErrorDescription TrackBlocked;          // {point, count, x, y, z; mm; link, link or body}: a collision
extern const ErrorDescription TrackBroken;           // {point, count, x, y, z; mm}: a joint would have to jump
extern const ErrorDescription WaypointNameTaken;     // {name}: a configuration or a target has this name
extern const ErrorDescription PlansFull;             // {kind of entry, count, most}: there are too many entries
extern const ErrorDescription TargetStray;           // {target}: the body that the target belongs to is missing
extern const ErrorDescription FrameMissing;          // {name}: the cell has no such frame
extern const ErrorDescription FrameStray;            // {frame}: the body or link that carries it is missing
extern const ErrorDescription FrameMoves;            // {frame}: the robot that is planned for moves the frame
extern const ErrorDescription ArmMissing;            // {name}: the cell has no such robot
extern const ErrorDescription ArmNameUnusable;       // {name}: a robot cannot have this name
extern const ErrorDescription OnlyRobot;             // {robot}: the only robot cannot be removed
extern const ErrorDescription ArmOnRoot;             // {robot}: the base is the root, which cannot be moved
extern const ErrorDescription OfOtherArm;            // {configuration or path, its robot}: another robot is planned
extern const ErrorDescription ToolOutOfReach;        // {x, y, z; mm}: out of reach even without joint limits
extern const ErrorDescription ToolBeyondLimits;      // {x, y, z; mm; joint}: the joint would exceed its limits
extern const ErrorDescription ToolBlocked;           // {x, y, z; mm; link, link or body}: a collision

}  // namespace handwheel::CellError
