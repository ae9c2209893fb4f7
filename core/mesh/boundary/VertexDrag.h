// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/FaceJoining.h"
#include "mesh/search/MovedFaces.h"

#include <memory>

namespace handwheel {

// A border vertex that is dragged, with all vertices at its position. They move together, so a pinched vertex stays
// pinched and a seam stays closed.
class VertexDrag {
 public:
  VertexDrag(std::shared_ptr<const FaceLocator> near, Vertex v);

  const Vec3& start() const { return m_start; }
  const std::vector<Face>& faces() const { return m_faces; }  // the faces that change

  // The point that a dragged vertex can reach. It is the target if no face would flip, lose its area or intersect
  // another face. Otherwise it is the last allowed point on the straight line from the start to the target, with the
  // first problem beyond that point.
  struct ReachablePoint {
    Vec3 point;
    JoinProblem problem = JoinProblem::None;
  };
  // Returns the point that the vertex can reach towards the target, rounded to the number type of the file.
  ReachablePoint towards(const Vec3& target, NumberType numbers = NumberType::Float64) const;
  // Returns the new shapes of the faces for a position of the vertex.
  std::vector<TrianglePoints> shapes(const Vec3& position) const;

  // Moves the vertices in a mesh. Returns false, without a change, if they are not at their start position or the new
  // position is not allowed. O(n).
  bool apply(HalfEdgeMesh& mesh, const Vec3& position) const;

 private:
  bool turnsAFace(const Vec3& position) const;
  bool crosses(const Vec3& position, const FaceLocator& near) const;

  std::shared_ptr<const FaceLocator> m_near;
  Vec3 m_start;
  std::vector<Vertex> m_vertices;
  std::vector<Face> m_faces;             // changing faces, in ascending order
  std::vector<TrianglePoints> m_before;  // shapes before the move, one per face
};

}  // namespace handwheel
