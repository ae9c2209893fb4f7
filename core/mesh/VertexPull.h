// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/FaceJoining.h"
#include "mesh/MovedFaces.h"

#include <memory>

namespace handwheel {

// A vertex of the border that is pulled, with all that lies at its position, so that a pinch stays one and a seam stays
// closed.
class VertexPull {
 public:
  VertexPull(std::shared_ptr<const NearFaces> near, Vertex v);

  const Vec3& start() const { return m_start; }
  const std::vector<Face>& faces() const { return m_faces; }  // those that change

  // The place, where no face would turn over, lose its area or cross another there; else how near to it the first of
  // these lets it come on a straight way from the start, and which it is.
  struct Place {
    Vec3 point;
    JoinProblem problem = JoinProblem::None;
  };
  Place towards(const Vec3& target) const;
  // The faces that change, as they would be.
  std::vector<TrianglePoints> shapes(const Vec3& place) const;

  // Moves the vertices in a mesh, if they are where they were. False, and nothing changed, when they are not or may not
  // go there. O(n).
  bool apply(HalfEdgeMesh& mesh, const Vec3& place) const;

 private:
  bool turnsAFace(const Vec3& place) const;
  bool crosses(const Vec3& place, const NearFaces& near) const;

  std::shared_ptr<const NearFaces> m_near;
  Vec3 m_start;
  std::vector<Vertex> m_vertices;
  std::vector<Face> m_faces;             // rising
  std::vector<TrianglePoints> m_before;  // of each face
};

}  // namespace handwheel
