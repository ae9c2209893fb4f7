// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"
#include "proximity/TriangleHierarchy.h"

#include <optional>
#include <vector>

namespace handwheel {

// Computes signed distances of points from the surface of a mesh. Faces without area and faces whose corners are not
// finite are no part of it, except that, where no face has an area, those without are the surface. Immutable; read on
// any thread. Coordinates below 1e150.
class SurfaceDistance {
 public:
  // O(n log n), on all threads of the arena. Empty once cancelled.
  explicit SurfaceDistance(const HalfEdgeMesh& mesh, Progress progress = {});

  bool empty() const { return m_hierarchy.empty(); }
  const HalfEdgeMesh& mesh() const { return m_mesh; }
  const std::vector<Face>& faces() const { return m_faces; }  // the surface
  const TriangleHierarchy& hierarchy() const { return m_hierarchy; }

  struct Nearest {
    Vec3 point = Vec3::Zero();
    // mm; below zero on the side that faces look away from: of a closed surface that faces outward, inside. Decided by
    // the normal of the face, or the angle-weighted one of the edge or vertex, on which the point lies: right for every
    // closed surface that does not pass through itself (Bærentzen and Aanæs, "Signed distance computation using the
    // angle weighted pseudonormal", 2005). Beyond the border of an open one the sign means little.
    double distance = 0.0;
  };
  // None when the surface is empty or p is not finite.
  std::optional<Nearest> from(const Vec3& p) const;

 private:
  Vec3 normalAt(Face f, const Vec3& p, const Vec3& nearest) const;

  HalfEdgeMesh m_mesh;
  std::vector<Face> m_faces;
  std::vector<Vec3> m_normals;  // angle-weighted, per vertex slot, of any length
  TriangleHierarchy m_hierarchy;
};

}  // namespace handwheel
