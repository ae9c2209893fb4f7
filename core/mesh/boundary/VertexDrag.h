// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/FaceJoining.h"
#include "mesh/search/MovedFaces.h"

#include <memory>

namespace handwheel {

// A border vertex that is dragged, with all vertices at its position. So a pinched vertex stays pinched and a seam
// stays closed.
class VertexDrag {
 public:
  VertexDrag(std::shared_ptr<const FaceLocator> near, Vertex v);

  const Vec3& start() const { return m_start; }
  const std::vector<Face>& faces() const { return m_faces; }  // those that change

  // The place, where no face would flip, lose its area or intersect another there; else the point up to which the first
  // of these problems allows it to come on a straight line from the start, and which problem it is.
  struct Place {
    Vec3 point;
    JoinProblem problem = JoinProblem::None;
  };
  // numbers: of the file; the point is one that it can hold.
  Place towards(const Vec3& target, NumberType numbers = NumberType::Float64) const;
  // The faces that change, as they would be.
  std::vector<TrianglePoints> shapes(const Vec3& place) const;

  // Moves the vertices in a mesh, if they are at their old position. False, and nothing changed, when they are not or
  // the place is not allowed. O(n).
  bool apply(HalfEdgeMesh& mesh, const Vec3& place) const;

 private:
  bool turnsAFace(const Vec3& place) const;
  bool crosses(const Vec3& place, const FaceLocator& near) const;

  std::shared_ptr<const FaceLocator> m_near;
  Vec3 m_start;
  std::vector<Vertex> m_vertices;
  std::vector<Face> m_faces;             // rising
  std::vector<TrianglePoints> m_before;  // of each face
};

}  // namespace handwheel
