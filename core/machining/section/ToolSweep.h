// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/RoundedPolygon.h"
#include "machining/section/TurnedSection.h"

namespace handwheel {

// The convex shape that cuts. It is the hull of corners relative to the controlled point, offset by a radius.
struct SweptShape {
  std::vector<ProfilePoint> corners;  // (r, z), mm; at least one
  double radius = 0.0;                // mm

  static SweptShape of(const RoundedPolygon& section);
  SweptShape mirrored() const;  // in the axis
};

// Returns cutters whose union is the area that a shape sweeps in a move. shadows:
// vectors (mm) along which the area is extended, for example from the nose to the side of the shank; only a shape of
// one corner may have them. A straight move gives one cutter. The sweep along an arc is the union of the shape at the
// ends of the arc and where an edge is tangent to the motion, the rings that the corners sweep, and the area between
// them; each is bounded by exact lines and arcs.
std::vector<SectionCutter> cuttersOf(const SweptShape& shape, const ProfileSegment& move,
                                     std::span<const ProfilePoint> shadows = {});

}  // namespace handwheel
