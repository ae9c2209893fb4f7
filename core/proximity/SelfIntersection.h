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

using TrianglePair = std::pair<std::uint32_t, std::uint32_t>;

// The largest number of intersecting triangle pairs that are listed. It keeps malicious files from exhausting the
// memory.
inline constexpr std::size_t kMaxTrianglePairs = std::size_t{1} << 23;

// Finds all pairs (i < j) of intersecting triangles, as defined by trianglesMeet(). Triangles without area, and those
// with a coordinate that is not finite, are ignored. The result is sorted. If there are more than maxPairs, exactly
// maxPairs of them are returned, which are the same in each run. Returns nothing if cancelled; polls the cancel flag at
// least every 50 ms (beyond some five million triangles, at least once in each pass over them). O(n log n + c) for c
// pairs of overlapping boxes, where slivers count by the boxes of their pieces (splitSliverBoxes()) and fans of very
// many triangles by the boxes of their arcs (HighValenceFans). The search runs on all threads of the arena and uses
// about 100 bytes per triangle, or 300 with slivers.
std::optional<std::vector<TrianglePair>> selfIntersections(std::span<const Vec3> points,
                                                           std::span<const Triangle> triangles, Progress progress = {},
                                                           std::size_t maxPairs = kMaxTrianglePairs);

}  // namespace handwheel
