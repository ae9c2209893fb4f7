// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/ProfileSegment.h"

#include <functional>
#include <span>
#include <vector>

namespace handwheel {

// Fits lines and arcs to points along a curve, within a tolerance. Their number is as small as possible.
//
// Each begins and ends in one of the points. Greedy: a segment goes as far as all points under it allow, so exact lines
// and arcs are found whole. A line is preferred if both fit. tolerance: mm, > 0. O(n log n).
std::vector<ProfileSegment> fitSegments(std::span<const ProfilePoint> points, double tolerance);

// The same for a curve of one parameter 0…1 without corners; it is sampled as densely as the tolerance needs.
using ParametricCurve = std::function<ProfilePoint(double)>;
std::vector<ProfileSegment> fitSegments(const ParametricCurve& curve, double tolerance);

}  // namespace handwheel
