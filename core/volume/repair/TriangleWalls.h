// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

namespace handwheel {

// Thickens triangles to prisms, half of the thickness (mm) to either side. volumeOfSurface() takes such a surface also
// where the triangles enclose nothing, as open sheets and triangles that share no edges. Prisms overlap where triangles
// meet; on the outside of a bend what is between them is filled, round, at half of the thickness from the edge and its
// ends. In voxels a wall has dents of up to half a voxel at vertices. Triangles without area are left out. O(n log n).
TriangleSoup wallsOf(const TriangleSoup& surface, double thickness);

// What the area of a surface and of its walls follows from.
struct WallMeasure {
  double area = 0.0;   // mm², of the triangles
  double edges = 0.0;  // mm, of each triangle by itself

  // mm², of the prisms of wallsOf(); of the surface itself without a thickness (0).
  double areaWith(double thickness) const { return thickness > 0.0 ? 2.0 * area + thickness * edges : area; }
};
// O(n).
WallMeasure measureForWalls(const TriangleSoup& surface);

}  // namespace handwheel
