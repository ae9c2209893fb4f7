// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

#include <memory>
#include <span>

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
  // Returns true if a shell is closed, so that there is an inside. Each edge of it has two triangles.
  bool isClosed() const { return m_isClosed; }
  std::span<const Vec3> shellPoints() const { return m_shellPoints; }  // a point of each shell
  // Returns true if a point is inside a closed shell, according to the exact winding number. The result for a point on
  // the surface is arbitrary. O(log n) for ordinary surfaces, O(n) if all triangles lie above the point.
  bool contains(const Vec3& p) const;

  struct Hierarchy;  // defined in FclHierarchy.h
  const Hierarchy& hierarchy() const { return *m_hierarchy; }

 private:
  std::unique_ptr<const Hierarchy> m_hierarchy;
  Box m_bounds;
  std::vector<Vec3> m_shellPoints;
  bool m_isClosed = false;
};

}  // namespace handwheel
