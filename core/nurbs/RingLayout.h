// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "nurbs/ProfileCurve.h"
#include "nurbs/TessellationOptions.h"

#include <cstdint>

namespace handwheel {

// A ring of vertices on a circle around the axis, evenly spaced from +x. It is a single vertex if it is a point of the
// axis. Its neighbours in a layout are such points or rings of as many segments, twice or half as many.
struct Ring {
  double radius, z;  // mm
  std::uint32_t segments;
};

// Returns the number of triangles of the band between two neighbouring rings.
std::uint64_t bandTriangles(const Ring& a, const Ring& b);

// Computes the rings of a turned part for tessellation. In order: the lower end from the axis outwards, the lateral
// surface, the upper end back to the axis; for a closed profile the surface alone, with the first ring again as the
// last. O(rings). Errors: FileTooLarge {triangles, "", limit} if the tolerance needs more than the limit,
// ElementMalformed {profile}, Cancelled.
Result<std::vector<Ring>> computeRings(const ProfileCurve& profile, const TessellationOptions& options,
                                       Progress progress);

}  // namespace handwheel
