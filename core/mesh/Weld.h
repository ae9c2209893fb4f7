// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/TriangleSoup.h"

#include <span>
#include <vector>

namespace handwheel {

// Numbers points so that two have the same number exactly when their positions are equal (-0 equals 0). Numbers run
// from 0 in order of first appearance. O(n). Of no use once cancelled.
struct PointClasses {
  std::vector<std::uint32_t> classOf;         // per point
  std::vector<std::uint32_t> representative;  // per class: its first point
};
PointClasses classifyPoints(std::span<const Vec3> points, Progress progress = {});

// The soup with equal positions merged; triangle i stays triangle i. Points that no triangle uses are left out.
// Once cancelled, an empty one.
TriangleSoup weld(const TriangleSoup& soup, Progress progress = {});

// The soup with every coordinate as a file of this number type holds it.
void roundPoints(TriangleSoup& soup, NumberType numbers);

}  // namespace handwheel
