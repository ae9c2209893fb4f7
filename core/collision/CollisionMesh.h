// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

#include <memory>

namespace handwheel {

// A triangle mesh, prepared for distance queries. Immutable; any thread.
class CollisionMesh {
 public:
  // Triangles with coordinates that are not finite are left out. O(n log n).
  explicit CollisionMesh(const TriangleSoup& soup);
  ~CollisionMesh();
  CollisionMesh(const CollisionMesh&) = delete;
  CollisionMesh& operator=(const CollisionMesh&) = delete;

  const Box& bounds() const { return m_bounds; }  // mm; empty without triangles
  bool isClosed() const { return m_isClosed; }    // every edge has two triangles, which makes an inside
  // Whether a point is inside of a closed mesh: by the winding number, which is exact.
  // Either for a point on its surface. O(log n) on ordinary surfaces, O(n) where all of it lies above the point.
  bool contains(const Vec3& p) const;

  struct Hierarchy;  // of the library that does the queries
  const Hierarchy& hierarchy() const { return *m_hierarchy; }

 private:
  std::unique_ptr<const Hierarchy> m_hierarchy;
  Box m_bounds;
  bool m_isClosed = false;
};

}  // namespace handwheel
