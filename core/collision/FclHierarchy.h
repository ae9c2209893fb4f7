// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/CollisionMesh.h"

#include <fcl/geometry/bvh/BVH_model.h>

namespace handwheel {

// A hierarchy of tight bounding boxes (FCL's OBBRSS), for distances and collisions. FCL's sphere-swept rectangles (RSS)
// take thousands of times as long for collisions.
struct CollisionMesh::Hierarchy {
  std::shared_ptr<fcl::BVHModel<fcl::OBBRSSd>> model;
  std::vector<double> radii;           // mm: radii of the spheres around the boxes, node by node
  std::vector<std::uint32_t> numbers;  // indices of the model's triangles in the original soup
  std::vector<bool> isOfClosedShell;   // for each triangle of the model
};

}  // namespace handwheel
