// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/thread/PartThreads.h"
#include "mesh/structure/TriangleSoup.h"

namespace handwheel {

// A ring of indexed points around the axis, one for each direction of a circle.
struct SurfaceRing {
  std::uint32_t first = 0;  // index of its first point
  double radius = 0.0;      // mm, radius of the profile, without threads
  double otherSide = 0.0;   // mm, radius of the other side of the wall
  double z = 0.0;           // mm
};

// Adds the triangles of one side of a threaded part between a lower and an upper ring of points in the soup. Rows of
// points follow the helix of the groove, so that crests and bottoms are edges of triangles. Points of a row that would
// lie beyond a ring are moved into the ring. Triangles face away from the material. circle: the directions of the
// points, as points of the unit circle.
void addHelicalBand(TriangleSoup& soup, const std::vector<ProfilePoint>& circle, const PartThreads& threads,
                    const ThreadGroove& along, const SurfaceRing& lower, const SurfaceRing& upper);

}  // namespace handwheel
