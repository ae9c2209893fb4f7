// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/PartSurface.h"
#include "tools/cell/PlanOperation.h"

namespace handwheel {

// The operation "process": a path of the tool along a curve on a part.
const Operation& processOperation();

// The curve that these values choose on a part with this surface, in the frame of the robot's base, simplified and in
// the direction that is asked for. body: at its place there. Error: TrackMissing.
Result<SurfaceTrack> trackOn(const PartSurface& surface, const Body& body, const OperationValues& values);

// The part that the values name. Errors: BodyMissing, Ambiguous; PartCarried of one that the robot carries.
Result<BodyPointer> partCalled(const OperationValues& values, const CellScene& scene);

// Plans the tool's path along a curve on a part: to its first point from above, along it, away from its last; from and
// to places, if these are given. All of it is proven free. Errors: those of trackOn() and plannedThrough(),
// PoseOfTrackUnreachable, TrackBlocked, TrackBroken, PlaceMissing, Cancelled.
Result<PlannedPath> processPath(const CellScene& scene, const RobotCellSnapshot& cell, const OperationValues& values,
                                const PartSurface& surface, const Body& body, Progress progress = {});

}  // namespace handwheel
