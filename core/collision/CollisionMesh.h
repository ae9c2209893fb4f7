// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

#include <memory>

namespace handwheel {

// A triangle mesh, prepared for distance queries. Immutable; any thread.
class CollisionMesh {
 public:
  // Omits triangles with coordinates that are not finite. O(n log n).
  explicit CollisionMesh(const TriangleSoup& soup);
  ~CollisionMesh();
  CollisionMesh(const CollisionMesh&) = delete;
  CollisionMesh& operator=(const CollisionMesh&) = delete;

  const Box& bounds() const { return m_bounds; }  // mm; empty without triangles
  bool isClosed() const { return m_isClosed; }    // every edge has two triangles, so there is an inside
  // Returns true if a point is inside a closed mesh, by the winding number, which is exact. Arbitrary for a point on
  // its surface. O(log n) on ordinary surfaces, O(n) if all of it lies above the point.
  bool contains(const Vec3& p) const;

  struct Hierarchy;  // defined in the library that does the queries
  const Hierarchy& hierarchy() const { return *m_hierarchy; }

 private:
  std::unique_ptr<const Hierarchy> m_hierarchy;
  Box m_bounds;
  bool m_isClosed = false;
};

}  // namespace handwheel
