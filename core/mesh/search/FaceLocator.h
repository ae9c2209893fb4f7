// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/FaceHierarchy.h"

#include <functional>
#include <memory>
#include <unordered_set>
#include <vector>

namespace handwheel {

// A spatial search structure for the live faces of a mesh version. Faces without finite corners are never found.
class FaceLocator {
 public:
  // Creates a locator for queries within a box, without a hierarchy: O(n) to build, O(faces in the box) per query.
  FaceLocator(const HalfEdgeMesh& mesh, const Box& within);
  // Creates a locator with a hierarchy of this or an older version of the mesh. Faces that changed after that version
  // are tested one by one.
  FaceLocator(const HalfEdgeMesh& mesh, std::shared_ptr<const FaceHierarchy> older);

  const HalfEdgeMesh& mesh() const { return m_mesh; }

  // Calls visit(face) for each face whose box meets the box (boundaries included) until it returns false. Returns false
  // if a visit returned false.
  bool forEachInBox(const Box& box, const std::function<bool(Face)>& visit) const;
  // Returns the half-edges of proper faces that start at this position, from any of its vertices.
  std::vector<HalfEdge> leaving(const Vec3& p) const;

 private:
  HalfEdgeMesh m_mesh;
  std::shared_ptr<const FaceHierarchy> m_older;
  std::unordered_set<Face> m_listed;  // faces missing in the hierarchy
};

}  // namespace handwheel
