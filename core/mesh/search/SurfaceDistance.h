// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"
#include "proximity/TriangleHierarchy.h"

#include <optional>
#include <vector>

namespace handwheel {

// Computes signed distances of points from the surface of a mesh. Faces without area and faces with corners that are
// not finite are excluded; if no face has an area, those without area form the surface. Immutable; may be read on any
// thread. Coordinates must be below 1e150.
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
    // mm; negative behind the faces, that is, inside a closed surface that is oriented outwards. The sign is decided by
    // the normal of the face, or the angle-weighted one of the edge or vertex, on which the point lies: correct for
    // every closed surface without self-intersections (Bærentzen and Aanæs, "Signed distance computation using the
    // angle weighted pseudonormal", 2005). Beyond the border of an open surface the sign is not meaningful.
    double distance = 0.0;
  };
  // Returns nothing if the surface is empty or p is not finite.
  std::optional<Nearest> from(const Vec3& p) const;

 private:
  Vec3 normalAt(Face f, const Vec3& p, const Vec3& nearest) const;

  HalfEdgeMesh m_mesh;
  std::vector<Face> m_faces;
  std::vector<Vec3> m_normals;  // angle-weighted, per vertex slot, not normalised
  TriangleHierarchy m_hierarchy;
};

}  // namespace handwheel
