// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The error codes of planning in a robot cell.
namespace handwheel::CellError {

extern const ErrorDescription WaypointMissing;       // {text}: neither a configuration or target nor joint values
extern const ErrorDescription RobotUnknown;          // {text}: neither a robot of the program nor a file with one
extern const ErrorDescription PathMissing;           // {text}: neither a path of the cell nor a file
extern const ErrorDescription PathTooShort;          // {path}: fewer than two waypoints
extern const ErrorDescription WaypointCollides;      // {waypoint, link, link or body}
extern const ErrorDescription WaypointTooNear;       // {waypoint, link, link or body, mm}: no collision, but too close
extern const ErrorDescription WaypointBeyondLimits;  // {waypoint, joint}
extern const ErrorDescription RouteNotFound;         // {from, to, seconds}
extern const ErrorDescription OthersMoved;           // {waypoint}: joints beside the arm have other values
extern const ErrorDescription LineUnreachable;       // {waypoint, percent}: the arm cannot follow the line to it
extern const ErrorDescription PoseUnreachable;       // {motion}: no joint values reach this motion of a program
extern const ErrorDescription PathCollides;          // {path, number of collisions, link, link or body}: the first one
extern const ErrorDescription PathOutdated;          // {path, part}: the part whose curve it follows was moved
extern const ErrorDescription PathBaseMoved;         // {path}: the robot was moved after its curve was planned
extern const ErrorDescription PathToolChanged;       // {path}: its curve was planned with another tool centre point
extern const ErrorDescription PathTargetMoved;       // {path, target}: the tool does not reach the target any more
extern const ErrorDescription PathWaypointChanged;   // {path, configuration}: its joint values have changed
extern const ErrorDescription LineCollides;          // {waypoint, link, link or body}: the straight line to it
extern const ErrorDescription LineTooNear;           // {waypoint, link, link or body, mm}: the straight line to it
extern const ErrorDescription PartCarried;           // {body}: the robot itself carries it
extern const ErrorDescription TrackMissing;          // {body}: no curve was found there
extern const ErrorDescription DrawnCurveBroken;      // {numbers of two points}: no surface connects them
extern const ErrorDescription TrackOutOfReach;       // {point, count, x, y, z; mm}
extern const ErrorDescription TrackBlocked;          // {point, count, x, y, z; mm; link, link or body}
extern const ErrorDescription TrackBroken;           // {point, count, x, y, z; mm}: only with a jump of a joint
extern const ErrorDescription WaypointNameTaken;     // {name}: a configuration or a target has it
extern const ErrorDescription PlansFull;             // {what, count, most}: more than a cell can hold
extern const ErrorDescription TargetStray;           // {target}: the body that it belongs to is missing
extern const ErrorDescription FrameMissing;          // {name}: the cell has no such frame
extern const ErrorDescription FrameStray;            // {frame}: the body or link that carries it is missing
extern const ErrorDescription FrameMoves;            // {frame}: the robot that is planned for moves it
extern const ErrorDescription ArmMissing;            // {name}: the cell has no such robot
extern const ErrorDescription ArmNameUnusable;       // {name}
extern const ErrorDescription OnlyRobot;             // {robot}: it cannot be removed
extern const ErrorDescription ArmOnRoot;             // {robot}: it cannot be moved
extern const ErrorDescription OfOtherArm;            // {configuration or path, its robot}: not the one planned for
extern const ErrorDescription ToolOutOfReach;        // {x, y, z; mm}: out of reach even without joint limits
extern const ErrorDescription ToolBeyondLimits;      // {x, y, z; mm; joint}
extern const ErrorDescription ToolBlocked;           // {x, y, z; mm; link, link or body}: in the nearest solution

}  // namespace handwheel::CellError
