// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Progress.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace handwheel {

// All pairs (i < j) of triangles that meet in the sense of trianglesMeet(). Triangles without area take no part. Sorted.
// Empty optional when cancelled; looks at the cancel flag at least every 50 ms.
std::optional<std::vector<std::pair<std::uint32_t, std::uint32_t>>> selfIntersections(
    std::span<const Vec3> points, std::span<const Triangle> triangles, Progress progress = {});

}  // namespace handwheel
