// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedOutline.h"
#include "machining/target/ProfileSegment.h"

namespace handwheel {

// Fits lines and arcs to the samples of one side of a turned part. They are as few as stay within `chord` (mm, > 0) of
// the samples.
//
// What a tool left exactly, lines and arcs, is found exactly first, with the sharp corners in which they meet between
// two samples. Only what is short beside the tolerance, as the marks of feed, is then joined to longer lines and arcs.
// points: at equal steps of z, up or down. spacing: mm, of the samples. O(n log n).
std::vector<ProfileSegment> refitted(const std::vector<ProfilePoint>& points, double chord, double spacing);

// The curves of a piece: what encloses its material, and the hollows in it.
struct TurnedCurves {
  ProfileCurve outside;
  std::vector<ProfileCurve> cavities;
};

// The rational curves of degree 2 of an outline, within `chord` (mm) of its samples and moved by `base` (mm) along z.
// Errors: those of ProfileCurve.
Result<TurnedCurves> curvesOf(const TurnedOutline& outline, double chord, double spacing, double base);

}  // namespace handwheel
