// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

namespace handwheel {

// Thickens triangles to prisms, by half of the thickness (mm) on either side. volumeOfSurface() accepts the result even
// if the triangles enclose nothing, such as open sheets and unconnected triangles. Prisms overlap where triangles meet.
// On the outside of a bend, the gap between prisms is filled by a rounding around the edge and its ends, with a radius
// of half the thickness. In voxels, a wall has dents of up to half a voxel at vertices. Triangles without area are
// skipped. O(n log n).
TriangleSoup wallsOf(const TriangleSoup& surface, double thickness);

// The measures of a surface from which the area of its walls follows.
struct WallMeasure {
  double area = 0.0;   // mm², area of the triangles
  double edges = 0.0;  // mm, sum of the perimeters of the triangles

  // Returns the area of the prisms of wallsOf(), mm², or of the surface itself if the thickness is 0.
  double areaWith(double thickness) const { return thickness > 0.0 ? 2.0 * area + thickness * edges : area; }
};
// Measures a surface. O(n).
WallMeasure measureForWalls(const TriangleSoup& surface);

}  // namespace handwheel
