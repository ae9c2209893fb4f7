// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/PartSurface.h"
#include "tools/cell/path/PlanOperation.h"

namespace handwheel {

// The operation "process": a path of the tool along a curve on a part.
const Operation& processPathOperation();

// Values of "along"; those between are sections.
inline constexpr std::size_t kAlongEdge = 0, kAlongDrawn = 4;

// The curve that these values choose on a part with this surface, in the frame of the robot's base, simplified and in
// the direction that is asked for. body: at its place there. Errors: TrackMissing, DrawnCurveBroken, NumberMalformed.
Result<SurfaceTrack> trackOn(const std::shared_ptr<const PartSurface>& surface, const Body& body,
                             const OperationValues& values);
// The same for a curve that is known already, in the frame of the body, near to a place there. Empty: nothing is left.
SurfaceTrack finishedTrack(SurfaceTrack track, const Vec3& near, const Body& body, const OperationValues& values);

// The part that the values name. Errors: BodyMissing, Ambiguous; PartCarried of one that the robot carries.
Result<BodyPointer> partCalled(const OperationValues& values, const CellScene& scene);

// Plans the tool's path along a curve on a part: to its first point from above, along it, away from its last; from and
// to places, if these are given; then it does not depend on where the robot stands, unless all that are given are
// targets. All of it is proven free. Errors: those of trackOn() and plannedThrough(), PoseOfTrackUnreachable,
// TrackBlocked, TrackBroken, PlaceMissing, Cancelled. chosenAt: where the part was when the curve was chosen, which is
// at the same place of the part now; none: where it is. The path keeps what made it.
Result<PlannedPath> processPath(const CellScene& scene, const RobotCellSnapshot& cell, const OperationValues& values,
                                const std::shared_ptr<const PartSurface>& surface, const Body& body,
                                Progress progress = {}, const std::optional<Pose>& chosenAt = {});

// The values that a path was planned with, without those that the operation does not take any more.
OperationValues valuesOf(const PathProcess& process);

}  // namespace handwheel
