// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/CollisionMesh.h"

#include <fcl/geometry/bvh/BVH_model.h>

namespace handwheel {

// A hierarchy of tight bounding boxes (OBBRSS), for distances and collisions. FCL's spheres swept by rectangles take
// thousands of times as long for collisions.
struct CollisionMesh::Hierarchy {
  std::shared_ptr<fcl::BVHModel<fcl::OBBRSSd>> model;
  std::vector<double> radii;           // mm: radii of the spheres around the boxes, node by node
  std::vector<std::uint32_t> numbers;  // indices of its triangles in the original soup
};

}  // namespace handwheel
