// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"
#include "mesh/defects/MeshState.h"
#include "mesh/holes/HoleFiller.h"
#include "mesh/repair/OutcomeCounts.h"

#include <QStringList>

namespace handwheel {

// Returns the display name of a fill method ("Fair").
QString fillMethodName(FillMethod method);
// Returns one sentence on when to choose a fill method.
QString fillMethodHint(FillMethod method);

// Returns a sentence on how a patch differs from what the user chose. The result is empty if it does not. method: the
// method of the patch.
QString substituteText(Substitute substitute, FillMethod method);
// Returns the reason why the user should inspect a patch. The result is empty if the patch resembles its surroundings.
QString patchWarning(const PatchComparison& shape);
// Returns a sentence about material that a repair removed from the outside.
QString removalWarning(const FarthestRemovedVertex& removed, LengthUnit unit);
// Returns the name of a boundary loop, "Hole 3" or "Outer boundary 1". number: the number from LoopNumbers.
QString boundaryLoopName(bool isSheetBoundary, int number);
// Returns the reason why a hole stayed open, as the end of a sentence. Example: "every patch would intersect the part".
QString fillFailureReason(FillFailure failure);

// Returns a phrase for each outcome of the holes and outer boundaries: "26 of 28 holes filled", "2 could not be
// filled". The result is empty if there are no holes and no outer boundaries.
QStringList outcomeTexts(const LoopCounts& loops);
// Returns the changes of a repair besides filling, one phrase for each kind. The result is empty if there were no such
// changes.
QStringList repairSummary(const RepairReport& report, LengthUnit unit = LengthUnit::Millimetre);
// Formats a thickness as "0.01 to 0.05 mm", or "0.01 mm" if both limits have the same text. Adds the number of vertices
// at which the sheet is thinner than requested.
QString thicknessText(const SheetThickness& thickness, LengthUnit unit);

// Describes the outcomes for sheets: "3 of 4 thickened by 0.01 mm; 1 sheet left open: …", with one phrase for each
// reason to leave sheets open.
QString sheetsText(const SheetOutcomes& sheets, LengthUnit unit);

// Describes the state of a surface. The result is "closed, manifold, oriented, free of self-intersections, one piece",
// with the opposite word for each property that does not hold. Properties that were not examined are omitted.
QString stateText(const MeshState& state);

// Formats an area with three significant digits, or as a whole number: "12.3 mm²".
QString areaText(double squareMillimetres, LengthUnit unit);
// Formats a length with three significant digits, or as a whole number: "31.2 mm", "0.00123 mm", "1240 mm".
QString lengthText(double millimetres, LengthUnit unit);

}  // namespace handwheel
