// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/FaceHierarchy.h"
#include "viewport/surface/SurfaceGeometry.h"

#include <memory>

namespace handwheel {

// The prepared geometry of a part, for drawing and picking. In the frame of the part.
struct PartShape {
  Vec3 origin = Vec3::Zero();           // the point at the origin of the geometry
  std::vector<SurfaceGeometry> blocks;  // at least one
  std::shared_ptr<const FaceHierarchy> faces;
};

// Prepares the shape of a soup. Points at equal positions are merged, and edges are sharp as on a mesh. Any thread;
// about 2 s for a million triangles.
PartShape shapeOf(const TriangleSoup& soup);

// The extent of a soup: cheap enough for the window thread.
struct PartOutline {
  Box box;
  std::vector<Vec3> points;  // a few thousand at most, those that touch the box among them
};

// Computes the extent of a soup. most: the number of points to use; of larger soups every second, third, … one. Points
// that are not finite are skipped.
PartOutline outlineOf(const TriangleSoup& soup, std::size_t most);

}  // namespace handwheel
