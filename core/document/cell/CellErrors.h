// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The error codes of planning in a robot cell.
namespace handwheel::CellError {

extern const ErrorDescription PlaceMissing;       // {text} it names no configuration, nor are these joint values
extern const ErrorDescription RobotUnknown;       // {text} neither a robot of the program nor a file with one
extern const ErrorDescription PathMissing;        // {text} the cell has no such path, nor is it a file
extern const ErrorDescription PathTooShort;       // {path} it has fewer than two places
extern const ErrorDescription PlaceCollides;      // {place, link, link or body}
extern const ErrorDescription PlaceTooNear;       // {place, link, link or body, mm} they do not meet
extern const ErrorDescription PlaceBeyondLimits;  // {place, joint}
extern const ErrorDescription RouteNotFound;      // {from, to, seconds}
extern const ErrorDescription OthersMoved;        // {place} joints beside the arm stand elsewhere there
extern const ErrorDescription LineUnreachable;    // {place, percent} the arm cannot follow the straight line to it
extern const ErrorDescription PoseUnreachable;    // {motion} of a program: no joint values reach it
extern const ErrorDescription PathCollides;       // {path, count of collisions, link, link or body} first of them
extern const ErrorDescription PathOutdated;       // {path, part} the part that it leads along stands elsewhere now
extern const ErrorDescription PathBaseMoved;      // {path} its curve was planned with the robot elsewhere
extern const ErrorDescription PathToolChanged;    // {path} its curve was planned with another tool centre point
extern const ErrorDescription PathTargetMoved;    // {path, target} the tool does not come to that any more
extern const ErrorDescription PathPlaceChanged;   // {path, configuration} that is other joint values now
extern const ErrorDescription LineCollides;       // {place, link, link or body} the straight line to it
extern const ErrorDescription LineTooNear;        // {place, link, link or body, mm} on the straight line to it
extern const ErrorDescription PartCarried;        // {body} the robot itself carries it
extern const ErrorDescription TrackMissing;       // {body} no curve is where it was asked for
extern const ErrorDescription DrawnCurveBroken;   // {number of a place, the next} the surface does not lead there
extern const ErrorDescription TrackOutOfReach;    // {point, count, x, y, z; mm}
extern const ErrorDescription TrackBlocked;       // {point, count, x, y, z; mm; link, link or body}
extern const ErrorDescription TrackBroken;        // {point, count, x, y, z; mm} not without a leap of a joint
extern const ErrorDescription PlaceNameTaken;     // {name} by a configuration or a target
extern const ErrorDescription PlansFull;          // {what, count, most} more than a cell can hold
extern const ErrorDescription TargetStray;        // {target} the body that it is on is missing
extern const ErrorDescription FrameMissing;       // {name} the cell has no such frame
extern const ErrorDescription FrameStray;         // {frame} the body or link that carries it is missing
extern const ErrorDescription FrameMoves;         // {frame} the robot that is planned for moves it
extern const ErrorDescription ArmMissing;         // {name} the cell has no such robot
extern const ErrorDescription ArmNameUnusable;    // {name}
extern const ErrorDescription OnlyRobot;          // {robot} it cannot be removed
extern const ErrorDescription ArmOnRoot;          // {robot} it cannot be moved
extern const ErrorDescription OfOtherArm;         // {configuration or path, its robot} not the one planned for
extern const ErrorDescription ToolOutOfReach;     // {x, y, z; mm} whatever the limits
extern const ErrorDescription ToolBeyondLimits;   // {x, y, z; mm; joint}
extern const ErrorDescription ToolBlocked;        // {x, y, z; mm; link, link or body} by the nearest way

}  // namespace handwheel::CellError
