// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/FaceHierarchy.h"
#include "viewport/surface/SurfaceGeometry.h"

#include <memory>

namespace handwheel {

// The prepared geometry of a part, for drawing and picking. Positions are in the frame of the part.
struct PartShape {
  Vec3 origin = Vec3::Zero();           // the point at the origin of the geometry
  std::vector<SurfaceGeometry> blocks;  // at least one
  std::shared_ptr<const FaceHierarchy> faces;
};

// Prepares the shape of a soup. Points at equal positions are merged, and edges are sharp as on a mesh. May be called
// on any thread. Takes about 2 s for a million triangles.
PartShape shapeOf(const TriangleSoup& soup);

// The extent of a soup. Its computation is fast enough for the window thread.
struct PartOutline {
  Box box;
  std::vector<Vec3> points;  // at most a few thousand points, including those that touch the box
};

// Computes the extent of a soup. most: the largest number of points to use. Of larger soups, only every second point,
// or every third, … is used. Points that are not finite are skipped.
PartOutline outlineOf(const TriangleSoup& soup, std::size_t most);

}  // namespace handwheel
