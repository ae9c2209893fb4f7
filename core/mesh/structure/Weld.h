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
  std::vector<std::uint32_t> classOf;         // per point
  std::vector<std::uint32_t> representative;  // per class: its first point
};
// Groups points by exactly equal positions. Two have the same class exactly when their positions are equal (-0 equals
// 0). Classes are numbered from 0 in order of first appearance. O(n). The result is invalid if cancelled.
PointClasses classifyPoints(std::span<const Vec3> points, Progress progress = {});

// Merges the points of a soup that have equal positions. Triangle i stays triangle i. Points that no triangle uses are
// left out. The result is empty if cancelled.
TriangleSoup weld(const TriangleSoup& soup, Progress progress = {});

// Rounds every coordinate of a soup to the number type of a file.
void roundPoints(TriangleSoup& soup, NumberType numbers);

}  // namespace handwheel
