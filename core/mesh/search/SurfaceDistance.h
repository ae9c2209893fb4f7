// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"
#include "proximity/TriangleHierarchy.h"

#include <optional>
#include <vector>

namespace handwheel {

// Computes signed distances of points from the surface of a mesh. Faces without area and faces with corners that are
// not finite are excluded; if no face has an area, those without area form the surface. The object is immutable and may
// be read on any thread. Coordinates must be below 1e150.
class SurfaceDistance {
 public:
  // Builds the surface in O(n log n), on all threads of the arena. The surface is empty if cancelled.
  explicit SurfaceDistance(const HalfEdgeMesh& mesh, Progress progress = {});

  bool empty() const { return m_hierarchy.empty(); }
  const HalfEdgeMesh& mesh() const { return m_mesh; }
  const std::vector<Face>& faces() const { return m_faces; }  // faces of the surface
  const TriangleHierarchy& hierarchy() const { return m_hierarchy; }

  struct Nearest {
    Vec3 point = Vec3::Zero();
    // Signed distance, mm. It is negative behind the faces, that is, inside a closed surface that is oriented outwards.
    // The sign is decided by the normal of the face, or by the angle-weighted normal of the edge or vertex on which the
    // nearest point lies. This is correct for every closed surface without self-intersections (Bærentzen and Aanæs,
    // "Signed distance computation using the angle weighted pseudonormal", 2005). Beyond the border of an open surface
    // the sign is not meaningful.
    double distance = 0.0;
  };
  // Returns the nearest point of the surface, or nothing if the surface is empty or p is not finite.
  std::optional<Nearest> from(const Vec3& p) const;

 private:
  Vec3 normalAt(Face f, const Vec3& p, const Vec3& nearest) const;

  HalfEdgeMesh m_mesh;
  std::vector<Face> m_faces;
  std::vector<Vec3> m_normals;  // angle-weighted normals per vertex slot, not normalised
  TriangleHierarchy m_hierarchy;
};

}  // namespace handwheel
