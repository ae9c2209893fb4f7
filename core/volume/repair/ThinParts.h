// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Progress.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace handwheel {

class BoundingTriangles;
class SparseVolume;
struct ClosedSurfaceInVoxels;

// Walls and gaps thinner than two voxels, as points of the surface beside them.
//
// A point is beside a thin wall if no ball of material with a diameter of two voxels touches the surface there, and the
// nearest such ball is farther than two voxels. So an edge between faces is thin only if its angle is below about 40°,
// and only where it is far thinner than two voxels. Gaps are walls of air.
struct ThinParts {
  struct Point {
    Vec3 at;           // mm
    Vec3 across;       // unit vector from the surface into the wall or gap
    double thickness;  // mm
    bool isStraight;   // the thickness is the distance to a surface that faces the point, and not the size of a ball
    double area;       // mm² of the surface that the point represents
  };
  double below = 0.0;  // mm, two voxels
  double area = 0.0;   // mm², the area of the surface that bounds material
  std::vector<Point> walls, gaps;
};

// Finds the thin parts of a surface. found: its triangles that bound the inside; bounding: those that may; own: the
// number of triangles that do not close a boundary. Up to 100,000 points of the surface are examined. Runs on all
// threads of the arena; O(n log n). The result is empty if cancelled.
ThinParts thinParts(const ClosedSurfaceInVoxels& surface, std::size_t own, const BoundingTriangles& found,
                    const std::vector<bool>& bounding, const Progress& progress);

// Figures of thin walls, or of thin gaps, in the result.
struct ThinFigures {
  double below = 0.0;         // mm, two voxels
  double area = 0.0;          // mm² of the surface beside them; 0: no more than rough surfaces have everywhere
  double share = 0.0;         // share of the surface
  double least = 0.0;         // mm, the smallest thickness
  Vec3 at = Vec3::Zero();     // mm, where they are thinnest
  double changedArea = 0.0;   // mm² beside walls that are lost, or gaps that are filled, by half or more
  double changedShare = 0.0;  // share of the surface
  bool isChanged() const { return changedArea > 0.0; }
};
enum class ThinKind { Walls, Gaps };
// Returns the figures of the walls or gaps. isInside: a function that returns true for a point (mm) in the material of
// the result; it is called on all threads of the arena.
ThinFigures thinFigures(const ThinParts& parts, ThinKind kind, const std::function<bool(const Vec3&)>& isInside);
// Returns the figures for the result of making a volume.
ThinFigures thinFigures(const ThinParts& parts, ThinKind kind, const SparseVolume& volume);

}  // namespace handwheel
