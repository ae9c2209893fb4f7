// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

#include <memory>

namespace handwheel {

// A triangle mesh, prepared for distance queries. It is immutable and may be used on any thread.
class CollisionMesh {
 public:
  // Prepares the triangles of a soup. Triangles with coordinates that are not finite are omitted. O(n log n).
  explicit CollisionMesh(const TriangleSoup& soup);
  ~CollisionMesh();
  CollisionMesh(const CollisionMesh&) = delete;
  CollisionMesh& operator=(const CollisionMesh&) = delete;

  const Box& bounds() const { return m_bounds; }  // mm; empty without triangles
  bool isClosed() const { return m_isClosed; }    // every edge has two triangles, so there is an inside
  // Returns true if a point is inside a closed mesh, according to the exact winding number. The result for a point on
  // the surface is arbitrary. O(log n) for ordinary surfaces, O(n) if all triangles lie above the point.
  bool contains(const Vec3& p) const;

  struct Hierarchy;  // defined in FclHierarchy.h
  const Hierarchy& hierarchy() const { return *m_hierarchy; }

 private:
  std::unique_ptr<const Hierarchy> m_hierarchy;
  Box m_bounds;
  bool m_isClosed = false;
};

}  // namespace handwheel
