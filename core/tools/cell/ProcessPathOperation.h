// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/PartSurface.h"
#include "tools/cell/path/PlanOperation.h"

namespace handwheel {

// Returns the operation "process": a path of the tool along a curve on a part.
const Operation& processPathOperation();

// Values of "along"; those between them are sections.
inline constexpr std::size_t kAlongEdge = 0, kAlongDrawn = 4;

// Returns the curve that these values choose on a part with this surface, in the frame of the robot's base, simplified
// and in the requested direction. body: with its pose in that frame. Errors: TrackMissing, DrawnCurveBroken,
// NumberMalformed.
Result<SurfaceTrack> trackOn(const std::shared_ptr<const PartSurface>& surface, const Body& body,
                             const OperationValues& values);
// Returns the same for a known curve in the frame of the body, near a point in that frame. Empty: nothing is left.
SurfaceTrack finishedTrack(SurfaceTrack track, const Vec3& near, const Body& body, const OperationValues& values);

// Returns the part that the values name. Errors: BodyMissing, Ambiguous; PartCarried if the robot carries it.
Result<BodyPointer> partCalled(const OperationValues& values, const CellScene& scene);

// Plans the tool's path along a curve on a part: to its first point from above, along it, away from its last; also from
// and to given waypoints. With waypoints it does not depend on the present joint values, unless all of them are
// targets. The whole path is proven free. Errors: those of trackOn() and plannedThrough(), PoseOfTrackUnreachable,
// TrackBlocked, TrackBroken, WaypointMissing, Cancelled. chosenAt: pose of the part when the curve was chosen, which
// has moved along with the part; nothing: its present pose. The path stores its values.
Result<PlannedPath> processPath(const CellScene& scene, const RobotCellSnapshot& cell, const OperationValues& values,
                                const std::shared_ptr<const PartSurface>& surface, const Body& body,
                                Progress progress = {}, const std::optional<Pose>& chosenAt = {});

// Returns the values that a path was planned with, without those that the operation no longer has.
OperationValues valuesOf(const PathProcess& process);

}  // namespace handwheel
