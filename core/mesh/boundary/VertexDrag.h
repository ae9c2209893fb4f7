// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/FaceJoining.h"
#include "mesh/search/MovedFaces.h"

#include <memory>

namespace handwheel {

// A border vertex that is dragged, with all vertices at its position. Therefore a pinched vertex stays pinched and a
// seam stays closed.
class VertexDrag {
 public:
  VertexDrag(std::shared_ptr<const FaceLocator> near, Vertex v);

  const Vec3& start() const { return m_start; }
  const std::vector<Face>& faces() const { return m_faces; }  // the faces that change

  // The target, if no face would flip, lose its area or intersect another there. Otherwise the last allowed point on
  // the straight line from the start, with the first problem behind it.
  struct ReachablePoint {
    Vec3 point;
    JoinProblem problem = JoinProblem::None;
  };
  // Returns the point that the vertex can reach towards the target, rounded to the number type of the file.
  ReachablePoint towards(const Vec3& target, NumberType numbers = NumberType::Float64) const;
  // Returns the new shapes of the faces for a position of the vertex.
  std::vector<TrianglePoints> shapes(const Vec3& position) const;

  // Moves the vertices in a mesh. Returns false, without a change, if they are not at their old position or the new one
  // is not allowed. O(n).
  bool apply(HalfEdgeMesh& mesh, const Vec3& position) const;

 private:
  bool turnsAFace(const Vec3& position) const;
  bool crosses(const Vec3& position, const FaceLocator& near) const;

  std::shared_ptr<const FaceLocator> m_near;
  Vec3 m_start;
  std::vector<Vertex> m_vertices;
  std::vector<Face> m_faces;             // ascending
  std::vector<TrianglePoints> m_before;  // one per face
};

}  // namespace handwheel
