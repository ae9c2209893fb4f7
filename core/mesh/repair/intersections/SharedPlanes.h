// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"
#include "proximity/SelfIntersection.h"

#include <map>
#include <span>
#include <vector>

namespace handwheel {

// Planes of surfaces that coincide except for rounding. Examples are the walls of two adjacent boxes that were rotated
// together: with the rounded numbers of a file, the walls cross at tiny angles.
struct SharedPlanes {
  struct Plane {
    Vec3 normal;  // unit length, except for rounding
    double offset = 0.0;
  };
  std::vector<Plane> planes;
  // Maps a point of the soup to the one, two or three planes in which it lies, ascending.
  std::map<std::uint32_t, std::vector<std::uint32_t>> planesOf;
  double reach = 0.0;  // mm; points at smaller distances may be equal except for rounding
  // Pairs of triangles that overlap in one of these planes, in addition to the given pairs.
  std::vector<TrianglePair> pairs;

  bool isEmpty() const { return planes.empty(); }
};

// Returns the distance (mm) by which rounding may move a corner from the plane of its surface. It is a few units in the
// last place of the largest coordinate, in single or double precision, depending on the coordinates, or a few steps of
// their decimals (CoordinateSteps). O(n).
double planarReach(const TriangleSoup& soup);

// Finds the planes that triangles of these pairs share up to the precision of the coordinates. The precision is single
// or double, depending on the coordinates. Planes of flat surroundings of such triangles are included. Planes that are
// merely near each other are excluded, as are those that would leave a point without a unique position: with more than
// three planes, or with two that are nearly parallel. O(n) for the soup and for each plane, O(k²) for k triangles in a
// plane; k and the number of planes are limited. Returns nothing for more than mostPairs pairs; by default these are
// folded regions of a scan, whose trials have no effort to spare.
SharedPlanes findSharedPlanes(const TriangleSoup& soup, std::span<const TrianglePair> pairs, Progress progress = {},
                              std::size_t mostPairs = 500);

}  // namespace handwheel
