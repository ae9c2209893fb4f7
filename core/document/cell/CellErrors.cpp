// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/CellErrors.h"

namespace handwheel {

const ErrorDescription CellError::WaypointMissing{
    .id = "PlaceMissing",
    .sentences = {translatable("ErrorText",
                               "'%1' is neither a configuration or target of the cell nor a value for each joint")},
    .advice = {translatable("ErrorText",
                            "Name a configuration or a target, or give the joint values in radians ('0 0.5 -1 …').")}};

const ErrorDescription CellError::RobotUnknown{
    .id = "RobotUnknown",
    .sentences = {translatable(
        "ErrorText",
        "'%1' is neither a URDF, a table after Denavit and Hartenberg, a robot cell nor a built-in robot")},
    .advice = {translatable("ErrorText", "Name a file of one of these kinds, or a robot as irb120 or ur5.")}};

const ErrorDescription CellError::PathMissing{
    .id = "PathMissing",
    .sentences = {translatable("ErrorText", "'%1' is neither a path of the cell nor a file")},
    .advice = {translatable("ErrorText", "Name a path of the cell ('inspect' lists them), or a file with one.")}};

const ErrorDescription CellError::PathTooShort{
    .id = "PathTooShort",
    .sentences = {translatable("ErrorText", "the path '%1' has fewer than two places")},
    .advice = {translatable("ErrorText", "Add the places that the robot is to move to.")}};

const ErrorDescription CellError::WaypointCollides{
    .id = "PlaceCollides",
    .sentences = {translatable("ErrorText", "at %1 the robot collides: %2 with %3")},
    .advice = {translatable("ErrorText", "Move the robot away there, or let two bodies touch that are meant to.")}};

const ErrorDescription CellError::WaypointTooNear{
    .id = "PlaceTooNear",
    .sentences = {translatable("ErrorText", "at %1 the robot is too near: %2 is %4 mm from %3")},
    .advice = {translatable("ErrorText", "Move the robot away there, or require less clearance.")}};

const ErrorDescription CellError::WaypointBeyondLimits{
    .id = "PlaceBeyondLimits",
    .sentences = {translatable("ErrorText", "at %1 the joint %2 is beyond its limits")},
    .advice = {translatable("ErrorText", "Give joint values within the limits.")}};

const ErrorDescription CellError::RouteNotFound{
    .id = "RouteNotFound",
    .sentences = {translatable("ErrorText", "no path from %1 to %2 was found in %3 s")},
    .advice = {translatable("ErrorText", "Allow more time, or insert a critical configuration in between.")}};

const ErrorDescription CellError::OthersMoved{
    .id = "OthersMoved",
    .sentences = {translatable("ErrorText", "at %1 a joint beside the arm, such as a finger, has another value")},
    .advice = {translatable("ErrorText", "Only the joints between base and tool are planned; the others must stay.")}};

const ErrorDescription CellError::LineUnreachable{
    .id = "LineUnreachable",
    .sentences = {translatable("ErrorText", "the arm cannot follow the straight line to %1: it stops after %2 %")},
    .advice = {translatable("ErrorText", "Use a joint motion, or choose the same configuration at both ends.")}};

const ErrorDescription CellError::PoseUnreachable{
    .id = "PoseUnreachable",
    .sentences = {translatable("ErrorText", "the robot cannot reach where motion %1 ends")},
    .advice = {translatable("ErrorText", "Check that the program is for this robot, its tool and its frame.")}};

const ErrorDescription CellError::PathCollides{
    .id = "PathCollides",
    .sentences = {translatable("ErrorText", "the path '%1' collides in %2 places, first %3 with %4")},
    .advice = {translatable("ErrorText", "Plan it again, or see all of them with 'verify'.")}};

const ErrorDescription CellError::ShapeMissing{
    .id = "ShapeMissing",
    .sentences = {translatable("ErrorText",
                               "the path '%1' is not proven free: the shape of %2 (%3) could not be read")},
    .advice = {translatable("ErrorText",
                            "Replace it by a body that the link carries, or leave it out of proofs, in the panel Cell "
                            "or by 'handwheel set CELL missing.LINK=…'.")}};

const ErrorDescription CellError::CornerNotProven{
    .id = "CornerNotProven",
    .sentences = {translatable("ErrorText",
                               "the path '%1' is not proven: CNT rounds the corner at place %2, and not everything "
                               "within the corner is free")},
    .advice = {translatable(
        "ErrorText", "Set its rounding to 0 (FINE), or change the places; on the command line: --cnt-as-fine.")}};

const ErrorDescription CellError::CarriedUnknown{
    .id = "CarriedUnknown",
    .sentences = {translatable("ErrorText",
                               "the proof of the path '%1' ends at place %2: '%3' may grip or release something")},
    .advice = {translatable("ErrorText",
                            "Say at that place that the robot carries the same as before; on the command line: "
                            "--carried same.")}};

const ErrorDescription CellError::PathOutdated{
    .id = "PathOutdated",
    .sentences = {translatable("ErrorText", "the path '%1' leads along the curve where '%2' was when it was planned")},
    .advice = {translatable("ErrorText", "Plan it again, or write it as it is; on the command line: --outdated.")}};

const ErrorDescription CellError::PathBaseMoved{
    .id = "PathBaseMoved",
    .sentences = {translatable("ErrorText", "the robot stood elsewhere when the curve of the path '%1' was planned")},
    .advice = {translatable("ErrorText", "Plan it again, or write it as it is; on the command line: --outdated.")}};

const ErrorDescription CellError::PathToolChanged{
    .id = "PathToolChanged",
    .sentences = {translatable("ErrorText", "the curve of the path '%1' was planned with another tool centre point")},
    .advice = {translatable("ErrorText", "Plan it again, or write it as it is; on the command line: --outdated.")}};

const ErrorDescription CellError::PathTargetMoved{
    .id = "PathTargetMoved",
    .sentences = {translatable("ErrorText", "the path '%1' leads to where the target '%2' was when it was planned")},
    .advice = {translatable("ErrorText", "Plan it again, or write it as it is; on the command line: --outdated.")}};

const ErrorDescription CellError::CoupledBeyondLimits{
    .id = "CoupledBeyondLimits",
    .sentences = {translatable("ErrorText", "the controller moves %1 %2 %3, which is %4° there, from %5° to %6° only")},
    .advice = {translatable("ErrorText", "Check that the program is for this robot, and change the joints there.")}};

const ErrorDescription CellError::PathFrameMoved{
    .id = "PathFrameMoved",
    .sentences = {translatable("ErrorText",
                               "the path '%1' leads to where the frame '%2' was when its program was opened")},
    .advice = {translatable("ErrorText",
                            "Open the program again or plan the path again, or write it as it is; on the command line: "
                            "--outdated.")}};

const ErrorDescription CellError::PathWaypointChanged{
    .id = "PathPlaceChanged",
    .sentences = {translatable("ErrorText", "the path '%1' leads to '%2' as that was stored when it was planned")},
    .advice = {translatable("ErrorText", "Plan it again, or write it as it is; on the command line: --outdated.")}};

const ErrorDescription CellError::LineCollides{
    .id = "LineCollides",
    .sentences = {translatable("ErrorText", "on the straight line to %1 the robot collides: %2 with %3")},
    .advice = {
        translatable("ErrorText", "Use a joint motion, change either place, or let bodies touch that are meant to.")}};

const ErrorDescription CellError::LineTooNear{
    .id = "LineTooNear",
    .sentences = {translatable("ErrorText", "on the straight line to %1 the robot is too near: %2 is %4 mm from %3")},
    .advice = {translatable("ErrorText",
                            "Use a joint motion, change this place or the one before, or require less clearance.")}};

const ErrorDescription CellError::PartCarried{
    .id = "PartCarried",
    .sentences = {translatable("ErrorText", "the robot carries '%1', so its tool cannot work on it")},
    .advice = {translatable("ErrorText", "Choose a part that stands in the cell, or take it off the robot.")}};

const ErrorDescription CellError::TrackMissing{
    .id = "TrackMissing",
    .sentences = {translatable("ErrorText", "no such curve was found on '%1'")},
    .advice = {translatable("ErrorText", "Choose a place on a sharp edge of the part, or a section through it.")}};

const ErrorDescription CellError::DrawnCurveBroken{
    .id = "DrawnCurveBroken",
    .sentences = {translatable("ErrorText", "places %1 and %2 of the curve are not connected by the surface")},
    .advice = {translatable("ErrorText", "Draw around the gap, or place more points.")}};

const ErrorDescription CellError::TrackOutOfReach{
    .id = "TrackOutOfReach",
    .sentences = {translatable("ErrorText",
                               "the robot cannot reach point %1 of %2 of the curve, at X %3 Y %4 Z %5 mm in the cell")},
    .advice = {translatable("ErrorText", "Move the part nearer, turn the tool, or let it turn about its own axis.")}};

const ErrorDescription CellError::TrackBlocked{
    .id = "TrackBlocked",
    .sentences = {translatable(
        "ErrorText", "at point %1 of %2 of the curve, X %3 Y %4 Z %5 mm in the cell, the robot collides: %6 with %7")},
    .advice = {
        translatable("ErrorText", "Tilt the tool away, keep a distance or less clearance, or let it touch the part.")}};

const ErrorDescription CellError::TrackBroken{
    .id = "TrackBroken",
    .sentences = {translatable(
        "ErrorText",
        "the arm cannot follow the curve to point %1 of %2, X %3 Y %4 Z %5 mm in the cell, without a jump of a joint")},
    .advice = {translatable("ErrorText", "Divide the curve, turn the tool, or let it turn about its own axis.")}};

const ErrorDescription CellError::WaypointNameTaken{
    .id = "PlaceNameTaken",
    .sentences = {translatable("ErrorText", "the cell already has a configuration or a target called '%1'")},
    .advice = {translatable("ErrorText", "Choose another name.")}};

const ErrorDescription CellError::PlansFull{
    .id = "PlansFull",
    .sentences = {translatable("ErrorText", "the cell would have %2 %1, and it can contain %3")},
    .advice = {translatable("ErrorText", "Remove what is not needed any more, or plan it in another cell.")}};

const ErrorDescription CellError::TargetStray{
    .id = "TargetStray",
    .sentences = {translatable("ErrorText", "the body that the target '%1' is on was removed")},
    .advice = {translatable("ErrorText", "Undo that, or remove the target.")}};

const ErrorDescription CellError::FrameMissing{
    .id = "FrameMissing",
    .sentences = {translatable("ErrorText", "the cell has no frame called '%1'")},
    .advice = {translatable("ErrorText", "Name one of its frames ('inspect' lists them).")}};

const ErrorDescription CellError::FrameStray{
    .id = "FrameStray",
    .sentences = {translatable("ErrorText", "what carries the frame '%1' was removed")},
    .advice = {translatable("ErrorText", "Undo that, or set the frame anew.")}};

const ErrorDescription CellError::FrameMoves{
    .id = "FrameMoves",
    .sentences = {translatable("ErrorText", "the robot moves the frame '%1', so that no program can be written in it")},
    .advice = {translatable("ErrorText", "Choose a frame that stands still while the robot moves.")}};

const ErrorDescription CellError::ArmMissing{
    .id = "ArmMissing",
    .sentences = {translatable("ErrorText", "the cell has no robot called '%1'")},
    .advice = {translatable("ErrorText", "Name one of its robots ('inspect' lists them).")}};

const ErrorDescription CellError::ArmNameUnusable{
    .id = "ArmNameUnusable",
    .sentences = {translatable("ErrorText", "'%1' cannot be the name of a robot")},
    .advice = {translatable("ErrorText", "Choose another name, of one line.")}};

const ErrorDescription CellError::OnlyRobot{
    .id = "OnlyRobot",
    .sentences = {translatable("ErrorText", "%1 is the only robot of the cell, which must have one")},
    .advice = {translatable("ErrorText", "Add another robot before this one is removed.")}};

const ErrorDescription CellError::ArmOnRoot{
    .id = "ArmOnRoot",
    .sentences = {translatable("ErrorText", "the base of %1 is the origin of the cell")},
    .advice = {translatable("ErrorText", "Move the other robots and the bodies instead.")}};

const ErrorDescription CellError::OfOtherArm{
    .id = "OfOtherArm",
    .sentences = {translatable("ErrorText", "'%1' belongs to another robot than the one to plan for: %2")},
    .advice = {translatable("ErrorText", "Choose that robot first; on the command line: --arm.")}};

const ErrorDescription CellError::ToolOutOfReach{
    .id = "ToolOutOfReach",
    .sentences = {translatable("ErrorText",
                               "the arm cannot bring its tool to X %1 Y %2 Z %3 mm in the cell in this orientation")},
    .advice = {translatable("ErrorText", "Choose a nearer place, or turn the tool.")}};

const ErrorDescription CellError::ToolBeyondLimits{
    .id = "ToolBeyondLimits",
    .sentences = {translatable(
        "ErrorText",
        "to bring the tool to X %1 Y %2 Z %3 mm in the cell in this orientation, joint %4 would exceed its limits")},
    .advice = {translatable("ErrorText", "Choose another place, or turn the tool.")}};

const ErrorDescription CellError::ToolBlocked{
    .id = "ToolBlocked",
    .sentences = {translatable(
        "ErrorText",
        "with its tool at X %1 Y %2 Z %3 mm in the cell the robot collides in every configuration: %4 with %5")},
    .advice = {translatable("ErrorText", "Choose another place, turn the tool, or require less clearance.")}};

}  // namespace handwheel
