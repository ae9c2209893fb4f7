// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/Picking.h"
#include "viewport/SurfaceGeometry.h"

#include <memory>

namespace handwheel {

// What drawing and picking need of a part's soup, in the frame of the part.
struct PartShape {
  Vec3 origin = Vec3::Zero();           // which point stands at the origin of the geometry
  std::vector<SurfaceGeometry> blocks;  // never empty
  std::shared_ptr<const PickIndex> index;
};

// Points at equal positions are one, and edges are sharp as on a mesh. Any thread; about 2 s for a million triangles.
PartShape shapeOf(const TriangleSoup& soup);

// How far a soup reaches: cheap enough for the window thread.
struct PartOutline {
  Box box;
  std::vector<Vec3> points;  // a few thousand at most, those that touch the box among them
};

// most: how many points are looked at; of larger soups every second, third, … one. Points that are not finite are left
// out.
PartOutline outlineOf(const TriangleSoup& soup, std::size_t most);

}  // namespace handwheel
