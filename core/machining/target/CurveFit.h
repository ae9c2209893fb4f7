// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/ProfileSegment.h"

#include <functional>
#include <span>
#include <vector>

namespace handwheel {

// Fits lines and arcs, as few as possible, to points along a curve. The points are within the tolerance of the result.
//
// Each segment begins and ends in one of the points. The method is greedy: a segment extends as far as all points along
// it permit, so that exact lines and arcs are found whole. If a line and an arc both fit, the line is preferred.
// tolerance: mm, > 0. O(n log n).
std::vector<ProfileSegment> fitSegments(std::span<const ProfilePoint> points, double tolerance);

using ParametricCurve = std::function<ProfilePoint(double)>;

// Fits as few lines and arcs as possible to a curve without corners, whose parameter is 0…1. The curve is sampled as
// densely as the tolerance requires.
std::vector<ProfileSegment> fitSegments(const ParametricCurve& curve, double tolerance);

}  // namespace handwheel
