// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/CollisionMesh.h"

#include <fcl/geometry/bvh/BVH_model.h>

namespace handwheel {

// A hierarchy of tight bounding boxes (OBBRSS), for distances and collisions alike. FCL's spheres swept by rectangles
// need thousands of times as long for collisions.
struct CollisionMesh::Hierarchy {
  std::shared_ptr<fcl::BVHModel<fcl::OBBRSSd>> model;
  std::vector<double> radii;           // mm: of spheres around the boxes, node by node
  std::vector<std::uint32_t> numbers;  // of its triangles, in the soup that it was made of
};

}  // namespace handwheel
