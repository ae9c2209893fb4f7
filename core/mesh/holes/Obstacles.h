// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/holes/Patch.h"
#include "mesh/search/IncrementalHierarchy.h"
#include "mesh/structure/HalfEdgeMesh.h"
#include "proximity/TriangleHierarchy.h"

#include <vector>

namespace handwheel {

// The surface that a patch must not intersect or touch. It consists of a mesh and the patches that were added later.
class Obstacles {
 public:
  // Builds the hierarchy of the mesh. The object is invalid if cancelled.
  explicit Obstacles(const HalfEdgeMesh& mesh, Progress progress = {});

  Box bounds() const { return m_hierarchy.bounds(); }  // bounding box of the mesh without added patches
  bool hits(const TrianglePoints& t) const;
  // Returns true if a triangle of the patch intersects the surface, or two of its triangles intersect each other. The
  // result is invalid if cancelled.
  bool hits(const Patch& patch, Progress progress = {}) const;
  // Returns true if the surface has a vertex at exactly this position.
  bool hasVertexAt(const Vec3& p) const;
  void add(const Patch& patch);

  // Returns the edges of the surface that join two of these points, as sorted pairs of their indices (smaller first).
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edgesAmong(const std::vector<Vec3>& points) const;

 private:
  template <class Visit>
  bool forEachNear(const Box& box, Visit visit) const;

  TriangleHierarchy m_hierarchy;
  IncrementalHierarchy m_patches;
};

// Returns the corner positions of a patch's triangle.
inline TrianglePoints corners(const Patch& patch, const Triangle& t) {
  return {patch.points[t[0]], patch.points[t[1]], patch.points[t[2]]};
}

}  // namespace handwheel
