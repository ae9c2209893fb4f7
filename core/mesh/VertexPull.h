// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/NearFaces.h"

#include <vector>

namespace handwheel {

// Twice the area over the square of the longest side: 0 without area, 0.87 equilateral.
double slimness(const TrianglePoints& t);

// Whether a face may take this shape: neither turned by 90° or more, nor without area, nor much slimmer than it was
// unless it stays well shaped. A face that had no area may take any.
bool mayBecome(const TrianglePoints& before, const TrianglePoints& after);

// A vertex of the border that is pulled, with all that lies at its position, so that a pinch stays one and a seam stays
// closed.
class VertexPull {
 public:
  VertexPull(const NearFaces& near, Vertex v);

  const Vec3& start() const { return m_start; }
  const std::vector<Face>& faces() const { return m_faces; }  // those that change

  // How near to the place it gets on a straight way from the start before a face would turn over or lose its area.
  struct Place {
    Vec3 point;
    bool isStopped = false;
  };
  Place towards(const Vec3& target) const;
  // The faces that change, as they would be.
  TriangleSoup shapes(const Vec3& place) const;

  // Moves the vertices in a mesh, if they are where they were. False, and nothing changed, when they are not, or a face
  // would turn over.
  bool apply(HalfEdgeMesh& mesh, const Vec3& place) const;

 private:
  TrianglePoints shape(std::size_t i, const Vec3& place) const;
  bool isAllowed(const Vec3& place) const;

  Vec3 m_start;
  std::vector<Vertex> m_vertices;
  std::vector<Face> m_faces;
  std::vector<TrianglePoints> m_before;  // of each face
};

}  // namespace handwheel
