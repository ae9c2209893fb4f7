// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "nurbs/ProfileCurve.h"
#include "nurbs/TessellationOptions.h"

#include <cstdint>

namespace handwheel {

// Vertices on a circle round the axis, evenly spread from +x on; a single one where it is a point of the axis. Next to
// it in a layout stand only such a point and rings of as many segments, twice or half as many.
struct Ring {
  double radius, z;  // mm
  std::uint32_t segments;
};

// The triangles of the band between two neighbouring rings.
std::uint64_t bandTriangles(const Ring& a, const Ring& b);

// The rings of a closed part: its lower end from the axis outwards, its mantle, its upper end back to the axis.
// O(rings). Errors: FileTooLarge {triangles, "", limit} where the tolerance asks for more than the limit,
// ElementMalformed {profile}, Cancelled.
Result<std::vector<Ring>> layRings(const ProfileCurve& profile, const TessellationOptions& options, Progress progress);

}  // namespace handwheel
