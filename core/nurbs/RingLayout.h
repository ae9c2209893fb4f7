// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "nurbs/ProfileCurve.h"
#include "nurbs/TessellationOptions.h"

#include <cstdint>

namespace handwheel {

// A ring of vertices on a circle around the axis, evenly spaced from +x. A ring on the axis is a single vertex. The
// neighbours of a ring in a layout are single vertices, or rings with as many segments, twice as many or half as many.
struct Ring {
  double radius, z;  // mm
  std::uint32_t segments;
};

// Returns the number of triangles of the band between two neighbouring rings.
std::uint64_t bandTriangles(const Ring& a, const Ring& b);

// Computes the rings of a turned part for tessellation. They follow the lower end from the axis outwards, the lateral
// surface, and the upper end back to the axis. A closed profile has only the lateral surface, and its first ring is
// repeated as the last. O(rings). Errors: FileTooLarge {triangles, "", limit} if the tolerance needs more than the
// limit, ElementMalformed {profile}, Cancelled.
Result<std::vector<Ring>> computeRings(const ProfileCurve& profile, const TessellationOptions& options,
                                       Progress progress);

}  // namespace handwheel
