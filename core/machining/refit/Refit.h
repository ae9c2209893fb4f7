// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedOutline.h"
#include "machining/target/ProfileSegment.h"

namespace handwheel {

// Fits lines and arcs to the samples of one side of a turned part. They are the fewest that stay within `chord` (mm, >
// 0) of the samples.
//
// Lines and arcs that a tool left exactly are found first, with the sharp corners in which they meet between two
// samples. Only short pieces, such as feed marks, are then joined to longer lines and arcs within the tolerance.
// points: samples at equal steps of z, ascending or descending. spacing: their distance along z, mm. O(n log n).
std::vector<ProfileSegment> refitted(const std::vector<ProfilePoint>& points, double chord, double spacing);

// The curves of a piece: the outline of its material, and its cavities.
struct TurnedCurves {
  ProfileCurve outside;
  std::vector<ProfileCurve> cavities;
};

// Returns the rational curves of degree 2 of an outline, within `chord` (mm) of its samples and moved by `base` (mm)
// along z. Errors: those of ProfileCurve.
Result<TurnedCurves> curvesOf(const TurnedOutline& outline, double chord, double spacing, double base);

}  // namespace handwheel
