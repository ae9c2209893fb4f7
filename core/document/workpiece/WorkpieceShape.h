// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "document/workpiece/WorkpieceSnapshot.h"
#include "machining/refit/Refit.h"

namespace handwheel {

// Returns the profile curves of each piece of a workpiece at its position. An uncut bar gives its exact profile. The
// curves of a cut part are within half of the chord tolerance; the other half is left for triangles. O(samples).
// Errors: ElementMalformed {profile}, also if no material is left, and the other errors of ProfileCurve::make().
Result<std::vector<TurnedCurves>> curvesOf(const WorkpieceSnapshot& workpiece);

// Returns the triangles of a workpiece at its position, closed and within the chord tolerance. Errors: the errors of
// tessellate().
Result<TriangleSoup> placedTriangles(const WorkpieceSnapshot& workpiece, Progress progress);

// Returns a STEP file with one valid solid. If the workpiece is in several pieces, the solid is the piece at its free
// end. The file is read back and measured. The volume of the solid is that of the samples to 1e-4; feed marks may need
// a curve that is nearer to them than the chord tolerance. Errors: ClosedHollow, CheckFailed, and the errors of
// writeStep().
Result<std::string> checkedStep(const WorkpieceSnapshot& workpiece, Progress progress);

}  // namespace handwheel
