// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/PartSurface.h"
#include "tools/cell/path/PlanOperation.h"

namespace handwheel {

// Returns the operation "process", which plans a tool path along a curve on a part.
const Operation& processPathOperation();

// Values of "along". The values between these two denote sections.
inline constexpr std::size_t kAlongEdge = 0, kAlongDrawn = 4;

// Returns the curve that the values choose on a part. It is in the frame of the robot's base, simplified and in the
// requested direction. surface: the surface of the part. body: the part, with its pose in that frame. Errors:
// TrackMissing, DrawnCurveBroken, NumberMalformed.
Result<SurfaceTrack> trackOn(const std::shared_ptr<const PartSurface>& surface, const Body& body,
                             const OperationValues& values);
// Returns a known curve in the frame of the robot's base, cut, simplified and in the requested direction. track, near:
// the curve and a point near its beginning, in the frame of the body. The result is empty if nothing is left of the
// curve.
SurfaceTrack finishedTrack(SurfaceTrack track, const Vec3& near, const Body& body, const OperationValues& values);

// Returns the part that the values name. Errors: BodyMissing, Ambiguous; PartCarried if the robot carries it.
Result<BodyPointer> partCalled(const OperationValues& values, const CellScene& scene);

// Plans the tool's path along a curve on a part. It leads to the first point of the curve from above, along the curve,
// and away from its last point, and optionally from and to given waypoints. With given waypoints the path does not
// depend on the present joint values, unless all of them are targets. The whole path is proven free of collisions.
// chosenAt: pose of the part when the curve was chosen; the curve has moved with the part since. Nothing: the present
// pose. The path stores `values`. Errors: the errors of trackOn() and plannedThrough(), TrackOutOfReach, TrackBlocked,
// TrackBroken, WaypointMissing, FileTooLarge {"points", count, most}, Cancelled.
Result<PlannedPath> processPath(const CellScene& scene, const RobotCellSnapshot& cell, const OperationValues& values,
                                const std::shared_ptr<const PartSurface>& surface, const Body& body,
                                Progress progress = {}, const std::optional<Pose>& chosenAt = {});

// Returns the values that a path was planned with, without those that the operation no longer has.
OperationValues valuesOf(const PathProcess& process);

}  // namespace handwheel
