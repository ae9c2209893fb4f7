// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

#include <optional>
#include <vector>

namespace handwheel {

// The faces of a mesh that reach into a box, as a mesh. It is changed within the box, checked by itself, and put back.
// What happens within the box meets no face that is not in it: self-intersections and the faces of edges are counted
// there as in the whole, but for what is the same before and after.
class Submesh {
 public:
  // O(faces of the whole).
  Submesh(const HalfEdgeMesh& whole, const Box& box);

  const HalfEdgeMesh& mesh() const { return m_mesh; }
  std::size_t faceCount() const { return m_faceOf.size(); }
  // The half-edge of the submesh along one of the whole; kNone where it is not in it.
  HalfEdge halfEdgeOf(const HalfEdgeMesh& whole, HalfEdge h) const;

  // The box in which a changed version differs from the submesh, before and after. Faces of the submesh keep their
  // numbers in it, and new ones follow.
  Box changesIn(const HalfEdgeMesh& changed) const;
  // Replaces the submesh by a changed version. The changes must be within the box. The whole is to be relinked
  // (relink()).
  void writeBack(HalfEdgeMesh& whole, const HalfEdgeMesh& changed) const;

 private:
  HalfEdgeMesh m_mesh;
  std::vector<Face> m_faceOf;      // in the whole; rising
  std::vector<Vertex> m_vertexOf;  // the same
};

}  // namespace handwheel
