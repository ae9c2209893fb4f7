// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "document/workpiece/WorkpieceSnapshot.h"
#include "machining/refit/Refit.h"

namespace handwheel {

// The profile curves of a workpiece in its place, for each piece. Of a bar that was not cut its exact profile. Those of
// a part are within half of the chord tolerance: triangles of them have the other half. O(samples). Errors:
// ElementMalformed {profile} also where nothing is left, others of ProfileCurve.
Result<std::vector<TurnedCurves>> curvesOf(const WorkpieceSnapshot& workpiece);

// Its triangles where it stands, closed and within the chord tolerance. Errors: those of tessellate().
Result<TriangleSoup> placedTriangles(const WorkpieceSnapshot& workpiece, Progress progress);

// One valid solid as a STEP file: of a part that is parted off the piece at its free end. It is read back and measured.
// Its volume is that of the samples to 1e-4: where marks of feed need it, its curve is nearer to them than the chord
// tolerance. Errors: ClosedHollow, CheckFailed, those of writeStep().
Result<std::string> checkedStep(const WorkpieceSnapshot& workpiece, Progress progress);

}  // namespace handwheel
