// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/thread/PartThreads.h"
#include "mesh/structure/TriangleSoup.h"

namespace handwheel {

// A ring of indexed points around the axis, one in each direction of a circle.
struct SurfaceRing {
  std::uint32_t first = 0;  // index of its first point
  double radius = 0.0;      // mm, radius of the profile, without threads
  double otherSide = 0.0;   // mm, radius of the other side of the wall
  double z = 0.0;           // mm
};

// Adds the triangles of a side of a threaded part between two rings of the soup, the lower one first. Rows of points
// follow the helix of the groove, so that crest and bottom are edges; points of a row beyond a ring are moved into it.
// Triangles face away from the material. circle: the directions, at radius 1.
void addHelicalBand(TriangleSoup& soup, const std::vector<ProfilePoint>& circle, const PartThreads& threads,
                    const ThreadGroove& along, const SurfaceRing& lower, const SurfaceRing& upper);

}  // namespace handwheel
