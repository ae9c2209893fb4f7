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

// Planes of surfaces that coincide except for rounding. As the walls of two boxes that were placed and then rotated: in
// the numbers of a file the walls cross at angles of the last digits.
struct SharedPlanes {
  struct Plane {
    Vec3 normal;  // unit length, but for rounding
    double offset = 0.0;
  };
  std::vector<Plane> planes;
  // By point of the soup, ascending: the one, two or three planes in which it lies.
  std::map<std::uint32_t, std::vector<std::uint32_t>> planesOf;
  double reach = 0.0;  // mm; what is nearer than this may be the same but for rounding
  // Pairs that overlap in one of these planes, beside those that were given.
  std::vector<TrianglePair> pairs;

  bool isEmpty() const { return planes.empty(); }
};

// Finds the planes that triangles at these pairs share, as near as single or double precision shows, whichever the
// coordinates have; and where there are such, those of their flat surroundings. Planes that are merely near each other
// are none, nor is one in which a point would have no unique place any more: with more than three planes, or two that
// are nearly parallel. O(n) for the soup and for each plane, O(k²) for k triangles in a plane; k and the planes are
// limited.
SharedPlanes findSharedPlanes(const TriangleSoup& soup, std::span<const TrianglePair> pairs, Progress progress = {});

}  // namespace handwheel
