// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

#include <optional>
#include <vector>

namespace handwheel {

// The faces of a mesh that reach into a box, as a separate mesh. It is changed within the box, checked separately, and
// written back. Changes within the box affect no face outside the submesh. Therefore the numbers of self-intersections
// and of faces at edges change in the submesh as they would in the whole mesh.
class Submesh {
 public:
  // Extracts the submesh in O(faces of the whole mesh).
  Submesh(const HalfEdgeMesh& whole, const Box& box);

  const HalfEdgeMesh& mesh() const { return m_mesh; }
  std::size_t faceCount() const { return m_faceOf.size(); }
  // Returns the half-edge of the submesh for one of the whole mesh; kNone if it is not in the submesh.
  HalfEdge halfEdgeOf(const HalfEdgeMesh& whole, HalfEdge h) const;

  // Returns the box of all differences between a changed version and the submesh. Faces of the submesh keep their
  // numbers in the changed version, and added ones follow.
  Box changesIn(const HalfEdgeMesh& changed) const;
  // Replaces the faces of the submesh in the whole mesh by a changed version. The changes must be within the box. The
  // caller must relink the whole mesh (relink()).
  void writeBack(HalfEdgeMesh& whole, const HalfEdgeMesh& changed) const;

 private:
  HalfEdgeMesh m_mesh;
  std::vector<Face> m_faceOf;      // numbers in the whole mesh, ascending
  std::vector<Vertex> m_vertexOf;  // numbers in the whole mesh, ascending
};

}  // namespace handwheel
