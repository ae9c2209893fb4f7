// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

namespace handwheel {

class Viewport;

// Finds a view direction in which a region of a mesh is hardly obstructed. Returns the unit vector towards the viewer
// that is nearest to "outward" among those with little of the mesh in front of the region. "outward" may have any
// length; zero is returned unchanged. O(faces), about 0.1 s for a million faces.
Vec3 unobstructedDirection(const HalfEdgeMesh& mesh, const Box& region, const Vec3& outward);

// Returns true if a region is in the upper part of the view, not too small, seen from outside, and not covered by the
// model. outward: the direction to the outside, of any length; zero: any side is accepted.
bool isWellSeen(const Viewport& view, const Box& region, const Vec3& outward);

}  // namespace handwheel
