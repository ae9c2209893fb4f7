// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"

#include <span>
#include <vector>

namespace handwheel {

// Classes of points with equal positions.
struct PointClasses {
  std::vector<std::uint32_t> classOf;         // class of each point
  std::vector<std::uint32_t> representative;  // first point of each class
};
// Groups points by exactly equal positions. Two points have the same class if and only if their positions are equal (-0
// equals 0). Classes are numbered from 0 in order of first appearance. O(n). The result is invalid if cancelled.
PointClasses classifyPoints(std::span<const Vec3> points, Progress progress = {});

// Merges the points of a soup that have equal positions. Triangle i stays triangle i. Points that no triangle uses are
// omitted. The result is empty if cancelled.
TriangleSoup weld(const TriangleSoup& soup, Progress progress = {});

// Rounds every coordinate of a soup to the number type of a file.
void roundPoints(TriangleSoup& soup, NumberType numbers);

}  // namespace handwheel
