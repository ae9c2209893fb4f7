// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "document/workpiece/WorkpieceSnapshot.h"
#include "machining/refit/Refit.h"

namespace handwheel {

// Returns the profile curves of a workpiece at its position, for each piece. An uncut bar gives its exact profile.
// Those of a part are within half of the chord tolerance; the other half is left for triangles. O(samples). Errors:
// ElementMalformed {profile} also if nothing is left, others of ProfileCurve.
Result<std::vector<TurnedCurves>> curvesOf(const WorkpieceSnapshot& workpiece);

// Returns the triangles of a workpiece at its position, closed and within the chord tolerance. Errors: those of
// tessellate().
Result<TriangleSoup> placedTriangles(const WorkpieceSnapshot& workpiece, Progress progress);

// Returns one valid solid as a STEP file; if the part was parted off, the piece at its free end. The file is read back
// and measured. Its volume is that of the samples to 1e-4; feed marks may need a curve that is nearer to them than the
// chord tolerance. Errors: ClosedHollow, CheckFailed, those of writeStep().
Result<std::string> checkedStep(const WorkpieceSnapshot& workpiece, Progress progress);

}  // namespace handwheel
