// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"
#include "mesh/defects/MeshState.h"
#include "mesh/holes/HoleFiller.h"
#include "mesh/repair/OutcomeCounts.h"

#include <QStringList>

namespace handwheel {

// The display name of a fill method ("Fair").
QString fillMethodName(FillMethod method);
// One sentence on when to choose a fill method.
QString fillMethodHint(FillMethod method);

// Why a person should look at a patch; empty where it is like its surroundings.
QString patchWarning(const PatchComparison& shape);
// A sentence about what a repair took away from the outside.
QString removalWarning(const FarthestRemovedVertex& removed, LengthUnit unit);
// The name of a boundary loop, "Hole 3" or "Outer boundary 1". number: by LoopNumbers.
QString boundaryLoopName(bool isSheetBoundary, int number);
// Why a hole stayed open, as the end of a sentence. Example: "every patch would intersect the part".
QString fillFailureReason(FillFailure failure);

// What became of the holes and outer boundaries, a phrase each: "26 of 28 holes filled", "2 could not be filled". Empty
// where nothing did.
QStringList outcomeTexts(const LoopCounts& loops);
// The changes of a repair besides filling, one phrase for each kind. Empty when there were none.
QStringList repairSummary(const RepairReport& report, LengthUnit unit = LengthUnit::Millimetre);
// "0.01 to 0.05 mm", or "0.01 mm" where both are written alike; and at how many vertices it is less than requested.
QString thicknessText(const SheetThickness& thickness, LengthUnit unit);

// "3 of 4 thickened by 0.01 mm; 1 sheet left open: " and why; for each reason.
QString sheetsText(const SheetOutcomes& sheets, LengthUnit unit);

// The state of a surface in words. "closed, manifold, oriented, free of self-intersections, one piece", or what of it
// does not hold; what was not looked for is left out.
QString stateText(const MeshState& state);

// Formats an area with three significant digits, or as a whole number: "12.3 mm²".
QString areaText(double squareMillimetres, LengthUnit unit);
// Formats a length with three significant digits, or as a whole number: "31.2 mm", "0.00123 mm", "1240 mm".
QString lengthText(double millimetres, LengthUnit unit);

}  // namespace handwheel
